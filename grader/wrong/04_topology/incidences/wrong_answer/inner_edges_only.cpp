// Counts only edges with a face on both sides.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/incidences.h"

Incidences incidences(const HalfEdgeTable& he) {
    int n = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1 && he[he[i].opp].fi != -1) ++n;
    return {n, n, he.size()};
}
