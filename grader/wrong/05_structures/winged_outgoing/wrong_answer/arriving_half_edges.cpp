// Lists the half-edges that arrive.
// Hint: You list the half-edges that arrive at the vertex.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, edge.to == v});
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return leaving;
}
