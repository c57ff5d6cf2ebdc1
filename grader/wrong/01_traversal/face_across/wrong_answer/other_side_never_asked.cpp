// Asks this side whether there is a face on the other one.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi == -1) return std::nullopt;
    return he[j].fi;
}
