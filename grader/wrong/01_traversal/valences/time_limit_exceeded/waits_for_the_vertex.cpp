// Walks along next until the vertex comes again; in a loose corner of the table
// it does not.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int start = 0; start < he.size(); start++) {
        int i = start;
        do {
            i = he[he[i].opp].next;
        } while (he[i].vi == he[start].vi && i != start + 1);
        valence[he[start].vi]++;
    }

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
