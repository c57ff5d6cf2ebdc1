// Searches the table for the half-edge between the last two vertices.
// Hint: You look through the whole table: what you need is a few steps away.
#include "exercises/05_structures/greedy_strip.h"

#include <set>

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    std::set<int> used;
    while (he[i].fi != -1 && used.insert(he[i].fi).second) {
        int face = he[i].fi;
        strip.push_back(he[he[he[i].next].next].vi);
        int a = strip[strip.size() - 2], b = strip.back();
        for (int k = 0; k < he.size(); ++k) {
            int tip = he[he[k].opp].vi;
            bool here = (he[k].vi == a && tip == b) || (he[k].vi == b && tip == a);
            if (here && he[k].fi != face) i = k;
        }
    }
    return strip;
}
