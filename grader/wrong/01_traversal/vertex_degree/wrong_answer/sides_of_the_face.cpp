// Walks round the face in place of the vertex.
// Hint: You walk round a face where the vertex was asked for.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[i].next;
    } while (i != start);
    return degree;
}
