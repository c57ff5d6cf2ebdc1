// Takes rows in order for the faces: row f for face f.
#include "exercises/03_building/anchors.h"

#include <cstddef>

Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count) {
    Anchors any;
    any.vertex.assign(static_cast<std::size_t>(vertex_count), -1);
    any.face.assign(static_cast<std::size_t>(face_count), -1);
    for (int i = 0; i < he.size(); ++i) {
        any.vertex[static_cast<std::size_t>(he[i].vi)] = i;
    }
    for (int f = 0; f < face_count; ++f)
        any.face[static_cast<std::size_t>(f)] = f < he.size() ? f : -1;
    return any;
}
