// Walks round each vertex from one half-edge: misses the other fans of a
// bow-tie.
// Hint: You walk round a vertex from one half-edge; where several fans meet,
// you miss the others.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int start = 0; start < he.size(); start++) {
        int v = he[start].vi;
        if (valence[v] > 0) continue;
        int i = start;
        do {
            valence[v]++;
            i = he[he[i].opp].next;
        } while (i != start);
    }

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
