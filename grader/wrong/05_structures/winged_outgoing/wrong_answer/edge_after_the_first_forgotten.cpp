// Begins with the edge after the first, and ends before it.
// Hint: You leave out the edge that the walk begins with.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    const WingedEdge* edge = &mesh.edges[static_cast<std::size_t>(start)];
    int e = edge->from == v ? edge->from_right : edge->to_left;
    while (e != start) {
        edge = &mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, edge->from == v});
        e = edge->from == v ? edge->from_right : edge->to_left;
    }
    return leaving;
}
