// Stops at the gap: the faces behind it are missing.
// Hint: You stop where there is no face; the walk goes on behind the gap.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi == -1) break;
        if (std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
