// Takes for B how many half-edges the border has.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) ++b;
    int s = components(he);
    return (2 * s - chi - b) / 2;
}
