// Joins the two ends of an edge, and not the roots of their trees.
// Hint: You do not follow the edges far enough: what several of them join
// comes out as several components.
#include "exercises/04_topology/components.h"

#include <map>

int components(const HalfEdgeTable& he) {
    std::map<int, int> parent;
    for (int i = 0; i < he.size(); ++i) parent[he[i].vi] = he[i].vi;
    for (int i = 0; i < he.size(); ++i) {
        int a = he[i].vi, b = he[he[i].opp].vi;
        if (a > b) parent[a] = b;
    }
    int roots = 0;
    for (const auto& [v, up] : parent)
        if (v == up) ++roots;
    return roots;
}
