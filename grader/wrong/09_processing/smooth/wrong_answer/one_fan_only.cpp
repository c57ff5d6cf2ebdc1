// Walks round the vertex from one half-edge: that is one fan only.
// Hint: You see one fan of a vertex only; it may have several.
#include "exercises/09_processing/smooth.h"

std::vector<Vec3> smooth(const HalfEdgeTable& he,
                         std::span<const Vec3> positions, int steps, double w) {
    if (steps < 0) throw std::invalid_argument("steps");
    auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<Vec3> now(positions.begin(), positions.end());
    std::vector<bool> fixed(positions.size(), false);
    std::vector<int> first(positions.size(), -1);
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi == -1) fixed[at(he[i].vi)] = true;
        first[at(he[i].vi)] = i;
    }
    for (int k = 0; k < steps; ++k) {
        std::vector<Vec3> before = now;
        for (std::size_t v = 0; v < now.size(); ++v) {
            if (fixed[v] || first[v] == -1) continue;
            Vec3 sum;
            double count = 0;
            int i = first[v];
            do {
                int j = he[i].opp;
                sum = sum + before[at(he[j].vi)];
                count += 1;
                i = he[j].next;
            } while (i != first[v]);
            now[v] = before[v] + w * ((1 / count) * sum - before[v]);
        }
    }
    return now;
}
