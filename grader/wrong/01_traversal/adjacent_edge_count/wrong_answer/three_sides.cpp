// Takes every face for a triangle.
// Hint: You take every face for a triangle.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int count = 0;
    for (int k = 0; k < 3; k++) {
        if (he[he[i].opp].fi != -1) count++;
        i = he[i].next;
    }
    return count;
}
