// Follows next until the face changes; it never does.
#include "exercises/01_traversal/face_across.h"

std::optional<int> face_across(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[j].fi == he[i].fi) j = he[j].next;
    return he[j].fi;
}
