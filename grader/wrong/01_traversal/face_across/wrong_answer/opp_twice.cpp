// Crosses the edge twice and is back.
// Hint: You stay on this side of the edge.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[he[i].opp].opp;
    if (he[j].fi == -1) return std::nullopt;
    return he[j].fi;
}
