// Reads the whole table to see how many faces there are.
// Hint: You look through the whole table: what you need is a few steps away.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    bool by_next = true;
    int faces = 0;
    for (int k = 0; k < he.size(); ++k) faces = he[k].fi > faces ? he[k].fi : faces;
    std::vector<bool> has(static_cast<std::size_t>(faces) + 1);
    while (he[i].fi != -1 && !has[static_cast<std::size_t>(he[i].fi)]) {
        has[static_cast<std::size_t>(he[i].fi)] = true;
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        i = he[by_next ? next : prev].opp;
        by_next = !by_next;
    }
    return strip;
}
