#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    // look for the half-edge whose opposite is i, it starts where i ends
    for (int j = 0; j < he.size(); ++j)
        if (he[j].opp == i) return he[j].vi;
    return -1;
}
