// Finds a loose edge by its free end: misses one that joins two others.
// Hint: You look for the free end of a loose edge; it may have none.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].next == j || he[j].next == i) return EdgeKind::dangling;
    if (he[i].fi == -1 || he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::interior;
}
