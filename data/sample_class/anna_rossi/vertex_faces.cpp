#include "exercises/01_traversal/vertex_faces.h"

#include <set>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i)
{
    std::vector<int> facce;
    std::set<int> viste;
    viste.insert(-1);   // così il bordo non entra mai nella lista
    int j = i;
    do {
        if (viste.insert(he[j].fi).second) facce.push_back(he[j].fi);
        j = he[he[j].opp].next;
    } while (j != i);
    return facce;
}
