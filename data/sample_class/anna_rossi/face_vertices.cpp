#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i)
{
    std::vector<int> v;
    if (he[i].fi < 0) return v;
    v.push_back(he[i].vi);
    for (int j = he[i].next; j != i; j = he[j].next) v.push_back(he[j].vi);
    return v;
}
