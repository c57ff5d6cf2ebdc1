// Leaves the walk after six faces, for fear that it never ends.
// Hint: You give up after a few steps; a vertex may have more faces.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    for (int steps = 0; steps < 6; steps++) {
        int fi = he[i].fi;
        if (fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[he[i].opp].next;
        if (i == start) break;
    }
    return faces;
}
