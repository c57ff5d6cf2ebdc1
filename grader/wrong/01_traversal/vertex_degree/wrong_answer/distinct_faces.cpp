// Counts the different faces round the vertex, the gap among them.
// Hint: You count faces, not edges: a face, or a gap, may lie between several
// pairs of edges.
#include "exercises/01_traversal/vertex_degree.h"

#include <set>

int vertex_degree(const HalfEdgeTable& he, int i) {
    std::set<int> faces;
    int start = i;
    do {
        faces.insert(he[i].fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return static_cast<int>(faces.size());
}
