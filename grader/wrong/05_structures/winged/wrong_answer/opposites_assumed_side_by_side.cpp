// Takes i ^ 1 for the opposite and i / 2 for the edge.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/05_structures/winged.h"

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void note(std::vector<int>& list, int k, int value) {
    if (at(k) >= list.size()) list.resize(at(k) + 1, -1);
    list[at(k)] = value;
}

}  // namespace

WingedMesh winged(const HalfEdgeTable& he) {
    std::vector<int> edge(at(he.size()), -1);
    int count = 0;
    for (int i = 0; i < he.size(); ++i) edge[at(i)] = i / 2;
    std::vector<int> prev(at(he.size()));
    for (int i = 0; i < he.size(); ++i) prev[at(he[i].next)] = i;
    WingedMesh mesh;
    for (int i = 0; i < he.size(); ++i) {
        note(mesh.vertex, he[i].vi, edge[at(i)]);
        if (he[i].fi != -1) note(mesh.face, he[i].fi, edge[at(i)]);
        int j = he[i].opp;
        if (i % 2 == 1) continue;
        mesh.edges.push_back({he[i].vi, he[j].vi, he[i].fi, he[j].fi,
                              edge[at(prev[at(i)])], edge[at(he[j].next)],
                              edge[at(he[i].next)], edge[at(prev[at(j)])]});
    }
    return mesh;
}
