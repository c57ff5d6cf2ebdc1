// Uses the face index as the index of a half-edge: he[-1] on the border.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    int fi = he[j].fi;
    if (he[fi].vi < 0 || fi == -1) return std::nullopt;
    return fi;
}
