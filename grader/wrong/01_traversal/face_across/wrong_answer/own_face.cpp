// Gives the face on this side.
// Hint: You stay on this side of the edge.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return std::nullopt;
    return he[i].fi;
}
