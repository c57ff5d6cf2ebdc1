// Believes that the two half-edges of an edge are rows 2k and 2k + 1.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i + 1 < he.size(); i += 2) {
        valence[he[i].vi]++;
        valence[he[he[i].next].vi]++;
    }

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
