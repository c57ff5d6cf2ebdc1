// Takes i ^ 1 for the opposite half-edge.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int fi = he[i ^ 1].fi;
    if (fi == -1) return std::nullopt;
    return fi;
}
