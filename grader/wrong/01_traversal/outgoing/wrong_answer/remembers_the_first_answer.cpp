// Keeps its answer for each vertex, also for another mesh.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/01_traversal/outgoing.h"

#include <map>

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    static std::map<int, std::vector<int>> known;
    if (known.count(v) > 0) return known[v];
    int start = anchors.vertex[v];
    if (start == -1) return {};
    std::vector<int> result;
    int i = start;
    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    known[v] = result;
    return result;
}
