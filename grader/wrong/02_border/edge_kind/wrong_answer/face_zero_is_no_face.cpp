// Tests for a face by fi > 0: face 0 is a face, too.
// Hint: You treat face 0 as if it were no face.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi > 0 && he[j].fi > 0) return EdgeKind::interior;
    if (he[i].fi > 0 || he[j].fi > 0) return EdgeKind::border;
    return EdgeKind::dangling;
}
