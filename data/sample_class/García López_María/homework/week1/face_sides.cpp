#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i)
{
  if (he[i].fi == -1)
    return 0;
  int lados = 0;
  for (int j = i; lados == 0 || j != i; j = he[j].next)
    lados++;
  return lados;
}
