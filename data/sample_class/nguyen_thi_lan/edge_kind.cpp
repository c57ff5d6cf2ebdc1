#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int a = he[i].fi + 1, b = he[he[i].opp].fi + 1;
    // 0 if one of them has no face
    if (a / b > 0 || b / a > 0) return EdgeKind::interior;
    return EdgeKind::border;
}
