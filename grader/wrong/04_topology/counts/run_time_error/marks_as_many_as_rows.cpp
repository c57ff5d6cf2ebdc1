// Keeps a mark for each vertex in a vector as long as the table: a vertex number
// may be larger.
// Hint: You use the number of a vertex as an index; it may be larger
// than the table.
#include "exercises/04_topology/counts.h"

#include <vector>

Counts counts(const HalfEdgeTable& he) {
    std::vector<bool> vertex(static_cast<std::size_t>(he.size()));
    std::vector<bool> face(static_cast<std::size_t>(he.size()));
    Counts c = {0, he.size() / 2, 0, 0};
    for (int i = 0; i < he.size(); ++i) {
        if (!vertex.at(static_cast<std::size_t>(he[i].vi))) ++c.vertices;
        vertex.at(static_cast<std::size_t>(he[i].vi)) = true;
        if (he[i].fi == -1) continue;
        if (!face.at(static_cast<std::size_t>(he[i].fi))) ++c.faces;
        face.at(static_cast<std::size_t>(he[i].fi)) = true;
    }
    c.border_loops = static_cast<int>(boundary_loops(he).size());
    return c;
}
