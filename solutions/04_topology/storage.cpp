#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    int half_edges = 2 * n.edges;
    int anchors = n.vertices + n.faces;

    int at_vertices = corners + 2 * n.edges;
    int at_edges = 2 * n.edges + corners;
    int at_faces = corners + corners;
    return {corners, 4 * half_edges, 4 * half_edges + anchors,
            8 * n.edges + anchors, at_vertices + at_edges + at_faces};
}
