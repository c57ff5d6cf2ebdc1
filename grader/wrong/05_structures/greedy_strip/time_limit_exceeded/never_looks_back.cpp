// Goes on until there is a border: never, on a closed mesh.
// Hint: You do not notice that the strip has come back to a triangle that it
// has.
#include "exercises/05_structures/greedy_strip.h"

std::vector<int> greedy_strip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int triangles = 0;
    bool by_next = true;
    for (int k = i; he[k].fi != -1; by_next = !by_next) {
        k = he[by_next ? he[k].next : he[he[k].next].next].opp;
        ++triangles;
    }
    std::vector<int> strip = {he[i].vi, he[he[i].next].vi};
    by_next = true;
    for (int t = 0; t < triangles; ++t) {
        strip.push_back(he[he[he[i].next].next].vi);
        i = he[by_next ? he[i].next : he[he[i].next].next].opp;
        by_next = !by_next;
    }
    return strip;
}
