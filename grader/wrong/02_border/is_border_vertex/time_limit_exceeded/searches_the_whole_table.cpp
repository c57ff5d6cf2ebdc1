// Right, but searches the whole table for half-edges of the vertex.
// Hint: Your answers are right, but you look through the whole table: what you
// need is a few steps away.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    for (int k = 0; k < he.size(); ++k)
        if (he[k].vi == he[i].vi && he[k].fi == -1) return true;
    return false;
}
