// Looks at the other side first and forgets the given one.
// Hint: You look at one side of the edge only.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::interior;
}
