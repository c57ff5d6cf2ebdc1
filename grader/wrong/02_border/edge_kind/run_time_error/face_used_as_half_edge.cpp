// Goes on from fi as if it were a half-edge: he[-1] on the border.
// Hint: You use the number of a face as that of a half-edge.
#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int across = he[he[i].opp].fi;
    if (he[across].fi == -1) return EdgeKind::border;
    if (he[he[i].fi].fi == -1) return EdgeKind::dangling;
    return EdgeKind::interior;
}
