// Adds up in single precision.
// Hint: Your numbers are not as exact as double is.
#include "exercises/09_processing/smooth.h"

#include <array>

std::vector<Vec3> smooth(const HalfEdgeTable& he,
                         std::span<const Vec3> positions, int steps, double w) {
    if (steps < 0) throw std::invalid_argument("steps");
    auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<Vec3> now(positions.begin(), positions.end());
    std::vector<bool> fixed(positions.size(), false);
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) fixed[at(he[i].vi)] = true;
    for (int k = 0; k < steps; ++k) {
        std::vector<std::array<float, 3>> sum(now.size());
        std::vector<double> count(now.size(), 0);
        for (int i = 0; i < he.size(); ++i) {
            std::size_t v = at(he[i].vi);
            Vec3 p = now[at(he[he[i].opp].vi)];
            sum[v][0] += static_cast<float>(p.x);
            sum[v][1] += static_cast<float>(p.y);
            sum[v][2] += static_cast<float>(p.z);
            count[v] += 1;
        }
        for (std::size_t v = 0; v < now.size(); ++v) {
            if (fixed[v] || count[v] == 0) continue;
            Vec3 mean = (1 / count[v]) * Vec3{sum[v][0], sum[v][1], sum[v][2]};
            now[v] = now[v] + w * (mean - now[v]);
        }
    }
    return now;
}
