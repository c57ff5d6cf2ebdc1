// Believes that half-edges stand in pairs 0-1, 2-3: opp is not read.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int j = i % 2 == 0 ? i + 1 : i - 1;
    int faces = (he[i].fi != -1) + (he[j].fi != -1);
    if (faces == 2) return EdgeKind::interior;
    if (faces == 1) return EdgeKind::border;
    return EdgeKind::dangling;
}
