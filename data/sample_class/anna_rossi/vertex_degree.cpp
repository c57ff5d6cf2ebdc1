#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i)
{
    int grado = 1;
    for (int j = he[he[i].opp].next; j != i; j = he[he[j].opp].next) grado++;
    return grado;
}
