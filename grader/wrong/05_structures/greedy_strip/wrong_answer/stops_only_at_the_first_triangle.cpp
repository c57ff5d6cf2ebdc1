// Looks out for the first triangle only; others come twice.
// Hint: You take a triangle again that the strip has already.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    bool by_next = true;
    int first = he[i].fi;
    while (he[i].fi != -1 && (strip.size() == 2 || he[i].fi != first) &&
           static_cast<int>(strip.size()) < he.size()) {
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        i = he[by_next ? next : prev].opp;
        by_next = !by_next;
    }
    return strip;
}
