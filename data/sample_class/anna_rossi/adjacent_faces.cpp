#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i)
{
    std::set<int> vicine;
    if (he[i].fi < 0) return {};
    int j = i;
    do {
        vicine.insert(he[he[j].opp].fi);
        j = he[j].next;
    } while (j != i);
    vicine.erase(-1);
    vicine.erase(he[i].fi);
    return std::vector<int>(vicine.begin(), vicine.end());
}
