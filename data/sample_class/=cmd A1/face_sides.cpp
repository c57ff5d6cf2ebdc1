#include "exercises/01_traversal/face_sides.h"

#include <algorithm>

int face_sides(const HalfEdgeTable& he, int i) {
    int f = he[i].fi;
    if (f == -1) return 0;
    return std::count_if(he.begin(), he.end(),
                         [f](const HalfEdge& h) { return h.fi == f; });
}
