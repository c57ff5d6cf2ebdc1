#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        bool known = std::find(faces.begin(), faces.end(), fi) != faces.end();
        if (fi != -1 && !known) faces.push_back(fi);
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    return faces;
}
