#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int f = he[he[i].opp].fi;
    if (f == -1) return std::nullopt;   // Rand
    return f;
}
