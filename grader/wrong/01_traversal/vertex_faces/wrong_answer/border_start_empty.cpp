// Answers nothing when i itself lies on the border.
// Hint: Look again at what you do when the half-edge itself has no face: its
// vertex may have faces all the same.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi != -1 &&
            std::find(faces.begin(), faces.end(), fi) == faces.end())
            faces.push_back(fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
