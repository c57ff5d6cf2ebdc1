// Adds up distances, not their squares.
// Hint: You add up distances, and not their squares.
#include "exercises/09_processing/simplify_quadric.h"

#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace {

struct Plane {
    Vec3 n, a;
};

double error(const std::vector<Plane>& planes, Vec3 p) {
    double sum = 0;
    for (const Plane& plane : planes) sum += std::abs(dot(plane.n, p - plane.a));
    return sum;
}

bool turns(const HalfEdgeTable& he, std::span<const Vec3> at, int i) {
    Vec3 to = at[std::size_t(he[he[i].opp].vi)];
    int start = i;
    do {
        if (he[i].fi == -1) return true;
        int k = he[i].next, l = he[k].next;
        Vec3 a = at[std::size_t(he[i].vi)];
        Vec3 b = at[std::size_t(he[k].vi)], c = at[std::size_t(he[l].vi)];
        if (i != start && he[i].fi != he[he[start].opp].fi &&
            !(dot(cross(b - a, c - a), cross(b - to, c - to)) > 0))
            return true;
        i = he[he[i].opp].next;
    } while (i != start);
    return false;
}

}  // namespace

HalfEdgeTable simplify_quadric(const HalfEdgeTable& he,
                               std::span<const Vec3> positions, int faces) {
    if (faces < 0) throw std::invalid_argument("faces");
    std::vector<std::vector<Plane>> planes(positions.size());
    HalfEdgeTable t = he;
    for (int i = 0; i < he.size(); ++i) {
        if (std::size_t(he[i].vi) >= positions.size())
            throw std::invalid_argument("position");
        if (he[i].fi == -1) continue;
        int k = he[i].next, l = he[k].next;
        if (he[l].next != i) throw std::invalid_argument("no triangle");
    }
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi == -1) continue;
        int k = he[i].next, l = he[k].next;
        Vec3 a = positions[std::size_t(he[i].vi)];
        Vec3 n = cross(positions[std::size_t(he[k].vi)] - a,
                       positions[std::size_t(he[l].vi)] - a);
        planes[std::size_t(he[i].vi)].push_back({n, a});
    }
    while (true) {
        std::set<int> numbers;
        for (const HalfEdge& row : t)
            if (row.fi != -1) numbers.insert(row.fi);
        if (int(numbers.size()) <= faces) return t;
        int best = -1;
        std::tuple<double, int, int> least;
        for (int i = 0; i < t.size(); ++i) {
            int u = t[i].vi, v = t[t[i].opp].vi;
            Vec3 p = positions[std::size_t(v)];
            std::tuple key(error(planes[std::size_t(u)], p) +
                               error(planes[std::size_t(v)], p),
                           u, v);
            if ((best != -1 && !(key < least)) || turns(t, positions, i) ||
                !can_collapse(t, i))
                continue;
            best = i;
            least = key;
        }
        if (best == -1) return t;
        for (const Plane& plane : planes[std::size_t(t[best].vi)])
            planes[std::size_t(t[t[best].opp].vi)].push_back(plane);
        t = collapse(t, best);
    }
}
