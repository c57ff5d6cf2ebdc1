// Has the mesh a border? Then that is one loop.
// Hint: You know one border loop at most.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    return {static_cast<int>(vertices.size()), he.size() / 2, static_cast<int>(faces.size()), boundary_loops(he).empty() ? 0 : 1};
}
