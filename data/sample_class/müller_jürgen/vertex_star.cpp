#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    std::vector<int> nachbarn;
    int start = i;
    i = he[i].opp;                  // jetzt zeigt i auf den Knoten ...
    do {
        nachbarn.push_back(he[i].vi);
        i = he[i].next;
        i = he[i].opp;
    } while (i != start);           // ... und kommt nie zu start zurueck
    return nachbarn;
}
