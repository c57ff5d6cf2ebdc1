// Walks round the face in place of the vertex.
// Hint: You walk round a face where the vertex was asked for.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> star;
    do {
        i = he[i].next;
        star.push_back(he[i].vi);
    } while (i != start);
    return star;
}
