// Works the loops out from V - E + F, as if the mesh were one sphere with holes.
// Hint: You work the loops out from the other counts, as if every mesh were
// one sphere with holes.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    int v = static_cast<int>(vertices.size());
    int e = he.size() / 2;
    int f = static_cast<int>(faces.size());
    return {static_cast<int>(vertices.size()), he.size() / 2, static_cast<int>(faces.size()), he.empty() ? 0 : 2 - v + e - f};
}
