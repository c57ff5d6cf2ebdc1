// Overwrites the answer at each half-edge: only the last one counts.
// Hint: You do not let every half-edge at the vertex have its say.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    bool border = false;
    int start = i;
    do {
        border = he[i].fi == -1;
        i = he[he[i].opp].next;
    } while (i != start);
    return border;
}
