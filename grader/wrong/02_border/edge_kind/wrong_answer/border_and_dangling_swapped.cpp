// Has the names of border and dangling the wrong way round.
// Hint: You have two kinds of edges the wrong way round.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi != -1 && he[j].fi != -1) return EdgeKind::interior;
    if (he[i].fi == -1 && he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::dangling;
}
