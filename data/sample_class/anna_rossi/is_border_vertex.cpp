#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i)
{
    bool bordo = he[i].fi < 0;
    for (int j = he[he[i].opp].next; j != i && !bordo; j = he[he[j].opp].next)
        bordo = he[j].fi < 0;
    return bordo;
}
