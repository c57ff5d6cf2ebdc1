#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i)
{
    std::vector<int> stella;
    int j = i;
    while (true) {
        // prima giro, poi guardo: la stella comincia dal secondo spigolo
        j = he[he[j].opp].next;
        stella.push_back(he[he[j].opp].vi);
        if (j == i) break;
    }
    return stella;
}
