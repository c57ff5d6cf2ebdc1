#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i)
{
    int quanti = 0;
    if (he[i].fi < 0) return quanti;
    int j = i;
    do {
        quanti += he[he[j].opp].fi >= 0 ? 1 : 0;
        j = he[j].next;
    } while (j != i);
    return quanti;
}
