// Turns the other way round the vertex.
// Hint: Your answers are the right ones, but the other way round.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, edge.from == v});
        e = edge.from == v ? edge.from_left : edge.to_right;
    } while (e != start);
    return leaving;
}
