// Takes Euler's formula for spheres backwards: 2 for each component.
#include "exercises/04_topology/components.h"

#include <set>

int components(const HalfEdgeTable& he) {
    std::set<int> vertices, faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    int v = static_cast<int>(vertices.size());
    int f = static_cast<int>(faces.size());
    return (v - he.size() / 2 + f + 1) / 2;
}
