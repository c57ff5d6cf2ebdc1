// Takes an edge with no face at all for a border edge.
// Hint: You take an edge without any face for a border edge.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (he[i].fi == -1 || he[j].fi == -1) return EdgeKind::border;
    return EdgeKind::interior;
}
