// Answers nothing when i itself lies on the border.
// Hint: You ask this side of the edge for a face, where the other one decides.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return std::nullopt;
    int fi = he[he[i].opp].fi;
    if (fi == -1) return std::nullopt;
    return fi;
}
