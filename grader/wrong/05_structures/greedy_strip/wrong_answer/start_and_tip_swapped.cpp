// Begins with the tip.
// Hint: You have the first two vertices the wrong way round.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[he[i].next].vi, he[i].vi};
    std::set<int> used;
    bool by_next = true;
    while (he[i].fi != -1 && !used.contains(he[i].fi)) {
        used.insert(he[i].fi);
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        i = he[by_next ? next : prev].opp;
        by_next = !by_next;
    }
    return strip;
}
