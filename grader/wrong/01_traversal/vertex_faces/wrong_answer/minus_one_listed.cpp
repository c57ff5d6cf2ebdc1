// Lists the gap at the border as face -1.
// Hint: You list -1 as a face where there is none.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    return faces;
}
