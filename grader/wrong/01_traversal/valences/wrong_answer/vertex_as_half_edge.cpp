// Takes the number of a vertex for a half-edge that leaves it.
// Hint: You use the number of a vertex as that of a half-edge.
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::map<int, int> histogram;
    for (int v = 0; v < vertex_count; v++) {
        int edges = 0;
        int i = v;
        do {
            edges++;
            i = he[he[i].opp].next;
        } while (i != v);
        histogram[edges]++;
    }
    return histogram;
}
