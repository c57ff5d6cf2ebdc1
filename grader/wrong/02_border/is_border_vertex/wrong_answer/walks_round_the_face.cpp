// Walks round the face: the face has a border edge, not the vertex.
// Hint: You walk round a face where the vertex was asked for.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        if (he[i].fi == -1 || he[he[i].opp].fi == -1) return true;
        i = he[i].next;
    } while (i != start);
    return false;
}
