// A half-edge with the face on its other side.
#include "exercises/03_building/anchors.h"

#include <cstddef>

Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count) {
    Anchors any;
    any.vertex.assign(static_cast<std::size_t>(vertex_count), -1);
    any.face.assign(static_cast<std::size_t>(face_count), -1);
    for (int i = 0; i < he.size(); ++i) {
        any.vertex[static_cast<std::size_t>(he[i].vi)] = i;
        int f = he[he[i].opp].fi;
        if (f != -1) any.face[static_cast<std::size_t>(f)] = i;
    }
    return any;
}
