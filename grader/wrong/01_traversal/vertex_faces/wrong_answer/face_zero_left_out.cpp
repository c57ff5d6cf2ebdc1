// Takes face 0 for no face.
// Hint: You treat face 0 as if it were no face.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi > 0 && std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
