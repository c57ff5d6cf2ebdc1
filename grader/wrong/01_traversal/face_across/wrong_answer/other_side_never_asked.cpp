// Asks this side whether there is a face on the other one.
// Hint: You ask this side of the edge for a face, where the other one decides.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi == -1) return std::nullopt;
    return he[j].fi;
}
