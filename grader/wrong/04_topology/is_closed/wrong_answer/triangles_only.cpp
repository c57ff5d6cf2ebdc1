// Compares 2E with 3F: that holds for closed meshes of triangles.
// Hint: You take every face for a triangle.
#include "exercises/04_topology/is_closed.h"

#include <set>

bool is_closed(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi != -1) faces.insert(he[i].fi);
    return he.size() == 3 * static_cast<int>(faces.size());
}
