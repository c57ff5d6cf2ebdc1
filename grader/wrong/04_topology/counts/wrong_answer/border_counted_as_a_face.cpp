// The -1 of the border goes in among the faces.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        faces.insert(he[i].fi);
    }
    return {static_cast<int>(vertices.size()), he.size() / 2, static_cast<int>(faces.size()), static_cast<int>(boundary_loops(he).size())};
}
