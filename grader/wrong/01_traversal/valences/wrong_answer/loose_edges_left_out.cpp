// Leaves the edges out that have no face on either side.
// Hint: You leave out edges that have no face.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++)
        if (he[i].fi != -1 || he[he[i].opp].fi != -1) valence[he[i].vi]++;

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
