// Compares the two sides: a face on both sides of one edge looks loose.
// Hint: You compare the two sides; the same face may lie on both of them.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi == he[j].fi) return EdgeKind::dangling;
    if (he[i].fi == -1 || he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::interior;
}
