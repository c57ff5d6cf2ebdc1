// Takes all faces for triangles.
// Hint: You take every face for a triangle.
#include "exercises/04_topology/incidences.h"

#include <set>

Incidences incidences(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1) faces.insert(he[i].fi);
    int n = 3 * static_cast<int>(faces.size());
    return {n, n, he.size()};
}
