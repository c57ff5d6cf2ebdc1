// Turns one way to the border, then the other way: out of order.
// Hint: You list what lies behind the border in the wrong order.
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
    const WingedEdge* edge = &mesh.edges[static_cast<std::size_t>(start)];
    int k = edge->from == v ? edge->from_left : edge->to_right;
    while (k != start && k != leaving.back().edge) {
        edge = &mesh.edges[static_cast<std::size_t>(k)];
        leaving.push_back({k, edge->from == v});
        k = edge->from == v ? edge->from_left : edge->to_right;
        if (leaving.size() > mesh.edges.size()) break;
    }
    return leaving;
}
