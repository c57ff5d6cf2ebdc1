// Finds a loose edge by its free end: misses one that joins two others.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].next == j || he[j].next == i) return EdgeKind::dangling;
    if (he[i].fi == -1 || he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::interior;
}
