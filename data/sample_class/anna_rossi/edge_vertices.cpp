#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i)
{
    std::array<int, 2> estremi;
    estremi[0] = he[i].vi;
    estremi[1] = he[he[i].next].vi;   // la prossima parte dove finisce i
    return estremi;
}
