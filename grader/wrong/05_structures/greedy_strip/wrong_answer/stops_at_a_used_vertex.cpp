// Ends where it comes to a vertex that the strip has already.
// Hint: You end the strip at a vertex that it has: a strip may pass a vertex
// several times.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    bool by_next = true;
    while (he[i].fi != -1 && !used.contains(he[he[he[i].next].next].vi)) {
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        used.insert({he[i].vi, he[next].vi, he[prev].vi});
        i = he[by_next ? next : prev].opp;
        by_next = !by_next;
    }
    return strip;
}
