// Leaves the sides out where the face meets itself.
// Hint: You leave out the sides where the face meets itself.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        int fj = he[he[i].opp].fi;
        if (fj != -1 && fj != fi) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
