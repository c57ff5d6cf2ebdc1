// Counts the rows of the vertex in the whole table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int degree = 0;
    for (int k = 0; k < he.size(); k++)
        if (he[k].vi == he[i].vi) degree++;
    return degree;
}
