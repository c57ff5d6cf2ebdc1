// Gives the two ends of a half-edge that has no face.
// Hint: Look again at what the contract says of a half-edge that has no face.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
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
