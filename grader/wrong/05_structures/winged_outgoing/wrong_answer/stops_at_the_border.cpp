// Ends where there is no face on the other side.
// Hint: You stop where there is no face; the walk goes on behind the gap.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, edge.from == v});
        if ((edge.from == v ? edge.right : edge.left) == -1) break;
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return leaving;
}
