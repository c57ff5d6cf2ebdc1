// Stops one edge too early.
// Hint: You stop one edge too early.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int degree = 0;
    for (int j = i; he[he[j].opp].next != i; j = he[he[j].opp].next) degree++;
    return degree;
}
