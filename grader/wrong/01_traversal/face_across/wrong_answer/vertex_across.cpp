// Gives the vertex of the opposite half-edge.
// Hint: You give a vertex where a face was asked for.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[j].fi == -1) return std::nullopt;
    return he[j].vi;
}
