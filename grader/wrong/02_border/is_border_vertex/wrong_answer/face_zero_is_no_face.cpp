// Takes face 0 for no face.
// Hint: You treat face 0 as if it were no face.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        if (he[i].fi <= 0) return true;
        i = he[he[i].opp].next;
    } while (i != start);
    return false;
}
