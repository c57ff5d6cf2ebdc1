// The list of the faces begins as zeros.
// Hint: You do not say -1 where a vertex or a face has no half-edge.
#include "exercises/03_building/anchors.h"

#include <cstddef>

Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count) {
    Anchors any;
    any.vertex.assign(static_cast<std::size_t>(vertex_count), -1);
    any.face.assign(static_cast<std::size_t>(face_count), 0);
    for (int i = 0; i < he.size(); ++i) {
        any.vertex[static_cast<std::size_t>(he[i].vi)] = i;
        if (he[i].fi != -1) any.face[static_cast<std::size_t>(he[i].fi)] = i;
    }
    return any;
}
