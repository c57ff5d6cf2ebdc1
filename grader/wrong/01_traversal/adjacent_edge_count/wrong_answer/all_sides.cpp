// Counts all sides of the face.
// Hint: You count sides that have no face on the other side.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
