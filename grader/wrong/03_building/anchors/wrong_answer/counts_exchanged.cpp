// Vertices get room for the faces, and faces for the vertices.
#include "exercises/03_building/anchors.h"

#include <cstddef>

Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count) {
    Anchors any;
    any.vertex.assign(static_cast<std::size_t>(face_count), -1);
    any.face.assign(static_cast<std::size_t>(vertex_count), -1);
    for (int i = 0; i < he.size(); ++i) {
        auto v = static_cast<std::size_t>(he[i].vi);
        if (v < any.vertex.size()) any.vertex[v] = i;
        auto f = static_cast<std::size_t>(he[i].fi);
        if (f < any.face.size()) any.face[f] = i;
    }
    return any;
}
