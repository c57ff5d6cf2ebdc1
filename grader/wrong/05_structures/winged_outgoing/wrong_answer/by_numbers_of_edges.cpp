// Looks through all edges: the order is that of the numbers.
// Hint: You list the edges by their numbers, not in the order of the walk.
#include "exercises/05_structures/winged_outgoing.h"

std::vector<DirectedEdge> winged_outgoing(const WingedMesh& mesh, int v) {
    std::vector<DirectedEdge> leaving;
    for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        if (edge.from == v) leaving.push_back({e, true});
        if (edge.to == v) leaving.push_back({e, false});
    }
    return leaving;
}
