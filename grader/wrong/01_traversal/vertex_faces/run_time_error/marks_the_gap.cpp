// Marks the faces that it has seen in an array, -1 too.
// Hint: You use the number of a face as an index, also where there is no face.
#include "exercises/01_traversal/vertex_faces.h"

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    std::vector<bool> seen(he.size(), false);
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (!seen[fi]) faces.push_back(fi);
        seen[fi] = true;
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
