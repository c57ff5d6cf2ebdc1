#include "grader/suites/09_processing/distance_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace course::oracle {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

double to_line_between(Vec3 x, Vec3 p, Vec3 q) {
    const double before = dot(x - p, q - p), after = dot(x - q, p - q);
    if (!(before > 0)) return length(x - p);
    if (!(after > 0)) return length(x - q);
    return length(cross(x - p, q - p)) / length(q - p);
}

/// The smallest distance to the segments that run across the triangle beside
/// p-q: convex in how far towards r they are, so that one may cut off a third
/// that does not hold the minimum, again and again.
double to_slices(Vec3 x, Vec3 p, Vec3 q, Vec3 r) {
    double low = 0, high = 1;
    const auto distance = [&](double u) {
        return to_line_between(x, p + u * (r - p), q + u * (r - q));
    };
    double nearest = std::min(distance(0), distance(1));
    for (int step = 0; step < 90; ++step) {
        const double u = low + (high - low) / 3, v = high - (high - low) / 3;
        const double at_u = distance(u), at_v = distance(v);
        nearest = std::min({nearest, at_u, at_v});
        (at_u < at_v ? high : low) = at_u < at_v ? v : u;
    }
    return nearest;
}

}  // namespace

double one_way_distance(const IndexedMesh& from, const IndexedMesh& to) {
    std::vector<bool> used(from.positions.size(), false);
    for (const int v : from.faces.corners()) used[at(v)] = true;
    double farthest = 0;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const FaceList::Face face : to.faces)
            nearest = std::min(
                nearest, to_slices(from.positions[v], to.positions[at(face[0])],
                                   to.positions[at(face[1])],
                                   to.positions[at(face[2])]));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

double surface_distance(const IndexedMesh& a, const IndexedMesh& b) {
    return std::max(one_way_distance(a, b), one_way_distance(b, a));
}

}  // namespace course::oracle
