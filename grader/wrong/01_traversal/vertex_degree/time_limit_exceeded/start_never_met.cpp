// Tests for the end between opp and next, where the start is never met.
// Hint: You wait for a start that your walk never meets.
#include "exercises/01_traversal/vertex_degree.h"

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i;
    int degree = 0;
    while (true) {
        degree++;
        i = he[i].opp;
        if (i == start) return degree;
        i = he[i].next;
    }
}
