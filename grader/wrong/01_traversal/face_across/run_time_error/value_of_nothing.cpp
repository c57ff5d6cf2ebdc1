// Asks for the value where there is none.
// Hint: You ask for the number of a face where there is none.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    std::optional<int> face;
    int fi = he[he[i].opp].fi;
    if (fi != -1) face = fi;
    return face.value();
}
