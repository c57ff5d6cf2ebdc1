// Keeps its answer for each half-edge, also for another mesh.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/01_traversal/vertex_degree.h"

#include <map>

int vertex_degree(const HalfEdgeTable& he, int i) {
    static std::map<int, int> known;
    if (known.count(i) > 0) return known[i];
    int start = i;
    int degree = 0;
    do {
        degree++;
        i = he[he[i].opp].next;
    } while (i != start);
    known[start] = degree;
    return degree;
}
