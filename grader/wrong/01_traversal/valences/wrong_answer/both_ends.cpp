// Counts each edge twice: for both its half-edges, at both ends.
// Hint: You count each edge of a vertex twice.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) {
        valence[he[i].vi]++;
        valence[he[he[i].opp].vi]++;
    }

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
