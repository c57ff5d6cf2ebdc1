#include "exercises/09_processing/smooth.h"

#include <string>

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Which vertices have an edge that lacks a face on a side.
std::vector<bool> on_border(const HalfEdgeTable& he, std::size_t vertices) {
    std::vector<bool> border(vertices, false);
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi != -1) continue;
        border[at(he[i].vi)] = true;
        border[at(he[he[i].opp].vi)] = true;
    }
    return border;
}

std::vector<Vec3> step(const HalfEdgeTable& he, const std::vector<Vec3>& before,
                       const std::vector<bool>& fixed, double w) {
    std::vector<Vec3> sum(before.size());
    std::vector<int> count(before.size(), 0);
    for (int i = 0; i < he.size(); ++i) {
        std::size_t v = at(he[i].vi);
        std::size_t neighbour = at(he[he[i].opp].vi);
        sum[v] = sum[v] + before[neighbour];
        ++count[v];
    }

    std::vector<Vec3> after = before;
    for (std::size_t v = 0; v < before.size(); ++v) {
        if (fixed[v] || count[v] == 0) continue;
        Vec3 mean = 1.0 / count[v] * sum[v];
        after[v] = before[v] + w * (mean - before[v]);
    }
    return after;
}

}  // namespace

std::vector<Vec3> smooth(const HalfEdgeTable& he,
                         std::span<const Vec3> positions, int steps, double w) {
    if (steps < 0)
        throw std::invalid_argument("steps: it is " + std::to_string(steps) +
                                    ", expected 0 or more");

    std::vector<Vec3> now(positions.begin(), positions.end());
    std::vector<bool> fixed = on_border(he, now.size());
    for (int k = 0; k < steps; ++k) now = step(he, now, fixed, w);
    return now;
}
