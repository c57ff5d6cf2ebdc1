// Takes face 0 for no face.
// Hint: You treat face 0 as if it were no face.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int fi = he[he[i].opp].fi;
    if (fi <= 0) return std::nullopt;
    return fi;
}
