// Looks at the given edge only, not at the others round the vertex.
// Hint: You do not let every half-edge at the vertex have its say.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    return he[i].fi == -1 || he[he[i].opp].fi == -1;
}
