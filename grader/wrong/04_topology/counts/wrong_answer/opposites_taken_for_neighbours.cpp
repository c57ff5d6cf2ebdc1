// Takes i and i ^ 1 for one edge and counts those pairs that end where they
// should.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    int edges = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i ^ 1].vi == he[he[i].next].vi) ++edges;
    return {static_cast<int>(vertices.size()), edges / 2, static_cast<int>(faces.size()), static_cast<int>(boundary_loops(he).size())};
}
