// Looks through the table once for each vertex and each face.
// Hint: Your answers are right, but you read the same rows of the table again
// and again.
#include "exercises/03_building/anchors.h"

namespace {

int leaving(const HalfEdgeTable& he, int v) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].vi == v) return i;
    return -1;
}

int along(const HalfEdgeTable& he, int f) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == f) return i;
    return -1;
}

}  // namespace

Anchors anchors(const HalfEdgeTable& he, int vertex_count, int face_count) {
    Anchors any;
    for (int v = 0; v < vertex_count; ++v)
        any.vertex.push_back(leaving(he, v));
    for (int f = 0; f < face_count; ++f) any.face.push_back(along(he, f));
    return any;
}
