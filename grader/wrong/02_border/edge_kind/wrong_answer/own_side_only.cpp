// Looks at the given side only: an edge with a face here counts as interior.
// Hint: You look at one side of the edge only.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    if (he[i].fi != -1) return EdgeKind::interior;
    if (he[he[i].opp].fi != -1) return EdgeKind::border;
    return EdgeKind::dangling;
}
