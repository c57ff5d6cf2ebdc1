// Always crosses the half-edge before the one it came by.
// Hint: You turn round one vertex all the time, as in a fan.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    while (he[i].fi != -1 && !used.contains(he[i].fi)) {
        used.insert(he[i].fi);
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        i = he[prev].opp;
    }
    return strip;
}
