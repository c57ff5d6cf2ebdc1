#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    std::vector<int> etoile;
    const int start = i;
    do {
        etoile.push_back(he[he[i].opp].vi);
        i = he[he[i].opp].next;
        if (he[i].fi == -1) break;      // le bord : on s'arrête
    } while (i != start);
    return etoile;
}
