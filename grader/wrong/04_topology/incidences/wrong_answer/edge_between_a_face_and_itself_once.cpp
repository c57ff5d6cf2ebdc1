// Counts an edge with the same face on both sides once.
// Hint: You count once what meets twice.
#include "exercises/04_topology/incidences.h"

Incidences incidences(const HalfEdgeTable& he) {
    int n = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1 && (he[i].fi != he[he[i].opp].fi || i < he[i].opp)) ++n;
    int m = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1) ++m;
    return {n, m, he.size()};
}
