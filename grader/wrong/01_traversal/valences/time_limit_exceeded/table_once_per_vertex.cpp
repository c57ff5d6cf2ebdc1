// Right, but looks through the whole table for each vertex.
// Hint: Your answers are right, but you look through the whole table for each
// vertex.
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::map<int, int> histogram;
    for (int v = 0; v < vertex_count; v++) {
        int edges = 0;
        for (int i = 0; i < he.size(); i++)
            if (he[i].vi == v) edges++;
        histogram[edges]++;
    }
    return histogram;
}
