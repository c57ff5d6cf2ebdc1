#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i)
{
    if (he[i].fi < 0) return 0;   // bordo: nessuna faccia

    int lati = 1;
    for (int j = he[i].next; j != i; j = he[j].next) lati++;
    return lati;
}
