// Answers 0 when i lies on the border.
// Hint: Look again at what you do when the half-edge itself has no face: its
// vertex has edges all the same.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    return degree;
}
