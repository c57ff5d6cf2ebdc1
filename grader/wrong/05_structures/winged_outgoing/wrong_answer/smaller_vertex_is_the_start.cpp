// Believes that edges leave the smaller of their vertices.
// Hint: You tell from the numbers of the vertices which way an edge is stored.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, v < edge.from + edge.to - v});
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return leaving;
}
