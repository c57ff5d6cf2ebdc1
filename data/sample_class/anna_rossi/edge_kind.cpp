#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i)
{
    int facce = 0;
    if (he[i].fi >= 0) facce++;
    if (he[he[i].opp].fi >= 0) facce++;
    switch (facce) {
        case 2: return EdgeKind::interior;
        case 1: return EdgeKind::border;
        default: return EdgeKind::dangling;
    }
}
