// Counts only edges with a face on one side at least.
// Hint: You leave out loose edges, or the vertices at their ends.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    int edges = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1 || he[he[i].opp].fi != -1) ++edges;
    return {static_cast<int>(vertices.size()), edges / 2, static_cast<int>(faces.size()), static_cast<int>(boundary_loops(he).size())};
}
