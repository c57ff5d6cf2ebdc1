// Right neighbours, but the other way round.
// Hint: Your answers are the right ones, but the other way round.
#include "exercises/01_traversal/vertex_star.h"

#include <algorithm>

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = he[i].opp;
        star.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    std::reverse(star.begin(), star.end());
    return star;
}
