#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors, int v)
{
    std::vector<int> uscenti;
    const int prima = anchors.vertex[v];
    if (prima < 0) return uscenti;   // vertice isolato

    int i = prima;
    do {
        i = he[he[i].opp].next;
        uscenti.push_back(i);
    } while (i != prima);
    return uscenti;
}
