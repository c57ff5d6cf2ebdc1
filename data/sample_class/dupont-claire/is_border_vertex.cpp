#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    return he[i].fi == -1 || he[he[i].opp].fi == -1;
}
