// Looks for the half-edges of the vertex in the whole table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    std::vector<int> star;
    for (int k = 0; k < he.size(); k++)
        if (he[k].vi == he[i].vi) star.push_back(he[he[k].opp].vi);
    return star;
}
