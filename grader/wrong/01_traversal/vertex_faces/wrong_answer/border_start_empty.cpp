// Answers nothing when i itself lies on the border.
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
