// Goes on to the next face by its number: he[-1] where there is no face.
// Hint: You use the number of a face as that of a half-edge.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        i = he[he[he[i].opp].fi].next;
        if (he[i].fi == -1) return true;
    } while (i != start && he[i].vi == he[start].vi);
    return false;
}
