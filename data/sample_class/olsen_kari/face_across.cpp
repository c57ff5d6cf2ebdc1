#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = he[i].next;   // the neighbour
    if (he[j].fi == -1) return std::nullopt;
    return he[j].fi;
}
