// Turns round the vertex in place of the face.
// Hint: You turn round a vertex where the face was asked for.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        i = he[i].opp;
        if (he[i].fi != -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
