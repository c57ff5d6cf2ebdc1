#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex)
{
    if (border < 0 || border >= he.size())
        throw std::invalid_argument("la half-edge non esiste");
    if (he[border].fi >= 0)
        throw std::invalid_argument("la half-edge non è sul bordo");

    HalfEdgeTable t = he;
    const int andata = t.size();
    const int ritorno = andata + 1;
    const int dopo = t[border].next;
    t.push_back(HalfEdge{t[dopo].vi, -1, ritorno, ritorno});
    t.push_back(HalfEdge{new_vertex, -1, dopo, andata});
    t[border].next = andata;
    return t;
}
