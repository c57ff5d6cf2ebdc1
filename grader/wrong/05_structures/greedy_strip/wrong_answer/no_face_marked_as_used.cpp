// Forgets the first triangle among those that it has.
// Hint: You take a triangle again that the strip has already.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    bool by_next = true;
    while (he[i].fi != -1 && !used.contains(he[i].fi)) {
        if (strip.size() > 2) used.insert(he[i].fi);
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        i = he[by_next ? next : prev].opp;
        by_next = !by_next;
    }
    return strip;
}
