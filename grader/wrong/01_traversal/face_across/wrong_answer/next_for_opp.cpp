// Goes to the next half-edge, not to the opposite one.
// Hint: You stay on this side of the edge.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int fi = he[he[i].next].fi;
    if (fi == -1) return std::nullopt;
    return fi;
}
