#include "exercises/02_border/edge_kind.h"

EdgeKind edge_kind(const HalfEdgeTable& he, int i) {
    int seiten[2] = {i, he[i].opp};
    int flaechen = 0;
    // rueckwaerts zaehlen, unsigned ist nie < 0 ...
    for (unsigned k = 1; k >= 0; k--)
        if (he[seiten[k % 2]].fi != -1 && k < 2) flaechen++;
    return flaechen == 2 ? EdgeKind::interior : EdgeKind::border;
}
