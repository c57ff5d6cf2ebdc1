// Turns the other way at edges that arrive, back and forth.
// Hint: You do not come back to the first edge: at some edges you go on the
// wrong way.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, edge.from == v});
        e = edge.from == v ? edge.from_right : edge.to_right;
    } while (e != start && leaving.size() < mesh.edges.size());
    return leaving;
}
