#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    int start = i;
    int n = 0;
    do {
        int neighbour = he[he[i].opp].fi;
        if (he[neighbour].fi != -1) n++;      // is there a face?
        i = he[i].next;
    } while (i != start);
    return n;
}
