// Takes the neighbouring row for the opposite: i ^ 1 is not opp.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    return {he[i].vi, he[i ^ 1].vi};
}
