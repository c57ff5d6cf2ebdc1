#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i)
{
  int grado = 0;
  int j = i;
  do {
    ++grado;
    j = he[j].opp;
    j = he[j].next;
  } while (j != i);
  return grado;
}
