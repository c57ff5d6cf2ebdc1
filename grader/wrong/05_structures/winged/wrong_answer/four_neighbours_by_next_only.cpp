// Has no way to find what comes before, and goes by opp and next.
// Hint: You do not find the edge that comes before another one.
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
    for (int i = 0; i < he.size(); ++i)
        if (i < he[i].opp) edge[at(i)] = edge[at(he[i].opp)] = count++;
    std::vector<int> prev(at(he.size()));
    for (int i = 0; i < he.size(); ++i) prev[at(he[i].next)] = i;
    WingedMesh mesh;
    for (int i = 0; i < he.size(); ++i) {
        note(mesh.vertex, he[i].vi, edge[at(i)]);
        if (he[i].fi != -1) note(mesh.face, he[i].fi, edge[at(i)]);
        int j = he[i].opp;
        if (j < i) continue;
        mesh.edges.push_back({he[i].vi, he[j].vi, he[i].fi, he[j].fi,
                              edge[at(he[he[i].opp].next)], edge[at(he[j].next)],
                              edge[at(he[i].next)], edge[at(he[he[j].opp].next)]});
    }
    return mesh;
}
