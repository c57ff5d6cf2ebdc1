// Gives each edge the direction that it is stored in.
// Hint: You give each edge in the direction in which it is stored.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, true});
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return leaving;
}
