// Turns twice to the same side where it would have to end.
// Hint: Where the strip should end, you go on across another side of the
// triangle.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    bool by_next = true;
    while (he[i].fi != -1 && !used.contains(he[i].fi)) {
        used.insert(he[i].fi);
        int next = he[i].next;
        int prev = he[next].next;
        strip.push_back(he[prev].vi);
        int across = he[by_next ? next : prev].opp;
        if (he[across].fi == -1 || used.contains(he[across].fi)) {
            across = he[by_next ? prev : next].opp;
            by_next = !by_next;
        }
        i = across;
        by_next = !by_next;
    }
    return strip;
}
