#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i)
{
    std::vector<int> giro;
    int prima = i;
    if (he[prima].fi >= 0) prima = he[i].opp;
    if (he[prima].fi >= 0) return giro;   // spigolo interno

    giro.push_back(prima);
    while (he[giro.back()].next != prima) giro.push_back(he[giro.back()].next);
    return giro;
}
