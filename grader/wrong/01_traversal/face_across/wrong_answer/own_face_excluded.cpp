// Takes a face that lies on both sides for no face.
// Hint: You take a face that lies on both sides of the edge for no face.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int fi = he[he[i].opp].fi;
    if (fi == -1 || fi == he[i].fi) return std::nullopt;
    return fi;
}
