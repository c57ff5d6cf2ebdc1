// Writes each vertex at once: later ones see moved neighbours.
// Hint: You mix positions from before the step with those of vertices that
// have moved already.
#include "exercises/09_processing/smooth.h"

std::vector<Vec3> smooth(const HalfEdgeTable& he,
                         std::span<const Vec3> positions, int steps, double w) {
    if (steps < 0) throw std::invalid_argument("steps");
    auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<Vec3> now(positions.begin(), positions.end());
    std::vector<bool> fixed(positions.size(), false);
    std::vector<int> first(positions.size(), -1);
    std::vector<std::vector<int>> out(positions.size());
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi == -1) fixed[at(he[i].vi)] = true;
        first[at(he[i].vi)] = i;
        out[at(he[i].vi)].push_back(i);
    }
    for (int k = 0; k < steps; ++k) {
        for (std::size_t v = 0; v < now.size(); ++v) {
            if (fixed[v] || first[v] == -1) continue;
            Vec3 sum;
            double count = 0;
            for (int i : out[v]) {
                sum = sum + now[at(he[he[i].opp].vi)];
                count += 1;
            }
            now[v] = now[v] + w * ((1 / count) * sum - now[v]);
        }
    }
    return now;
}
