// Finds out the direction of the first edge only, and gives up in the end.
// Hint: You do not come back to the first edge: at some edges you go on the
// wrong way.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return leaving;
    bool leaves = mesh.edges[static_cast<std::size_t>(start)].from == v;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        leaving.push_back({e, leaves});
        e = leaves ? edge.from_right : edge.to_left;
    } while (e != start && leaving.size() < mesh.edges.size());
    return leaving;
}
