// Pulls border vertices, too.
// Hint: You let vertices on the border go.
#include "exercises/09_processing/simplify_quadric.h"

#include <array>
#include <set>
#include <string>
#include <tuple>

namespace {

using Positions = std::span<const Vec3>;

/// The sum of squares of (n.x x + n.y y + n.z z + d) over planes, as the
/// coefficients of the products of x, y, z and 1.
using Quadric = std::array<std::array<double, 4>, 4>;

void add_plane(Quadric& q, Vec3 n, double d) {
    std::array<double, 4> plane = {n.x, n.y, n.z, d};
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) q[r][c] += plane[r] * plane[c];
}

void add(Quadric& q, const Quadric& other) {
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) q[r][c] += other[r][c];
}

double value(const Quadric& q, Vec3 p) {
    std::array<double, 4> x = {p.x, p.y, p.z, 1};
    double sum = 0;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) sum += q[r][c] * x[r] * x[c];
    return sum;
}

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

void require_triangles_with_positions(const HalfEdgeTable& he,
                                      Positions positions) {
    for (int i = 0; i < he.size(); ++i) {
        require(std::size_t(he[i].vi) < positions.size(),
                "vertex " + std::to_string(he[i].vi) + " has no position");
        require(he[i].fi == -1 || he[he[he[i].next].next].next == i,
                "face " + std::to_string(he[i].fi) + " is no triangle");
    }
}

int face_count(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (const HalfEdge& row : he)
        if (row.fi != -1) faces.insert(row.fi);
    return int(faces.size());
}

/// The normal of the triangle along i, with its first corner at `start`.
Vec3 normal(const HalfEdgeTable& he, Positions positions, int i, Vec3 start) {
    int second = he[i].next, third = he[second].next;
    return cross(positions[std::size_t(he[second].vi)] - start,
                 positions[std::size_t(he[third].vi)] - start);
}

std::vector<Quadric> quadrics(const HalfEdgeTable& he, Positions positions) {
    std::vector<Quadric> all(positions.size(), Quadric{});
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].fi == -1) continue;
        Vec3 a = positions[std::size_t(he[i].vi)];
        Vec3 n = normal(he, positions, i, a);
        add_plane(all[std::size_t(he[i].vi)], n, -dot(n, a));
    }
    return all;
}

/// Rules 2 and 3 for the pull of the start of i into its tip.
bool may_move(const HalfEdgeTable& he, Positions positions, int i) {
    Vec3 from = positions[std::size_t(he[i].vi)];
    Vec3 to = positions[std::size_t(he[he[i].opp].vi)];
    int start = i;
    do {
        bool stays = he[i].fi != -1 &&
            he[i].fi != he[start].fi && he[i].fi != he[he[start].opp].fi;
        if (stays && !(dot(normal(he, positions, i, from),
                           normal(he, positions, i, to)) > 0))
            return false;
        i = he[he[i].opp].next;
    } while (i != start);
    return true;
}

/// The half-edge whose start is pulled into its tip next; -1 when there is
/// none.
int best_pull(const HalfEdgeTable& he, Positions positions,
              const std::vector<Quadric>& quadrics) {
    int best = -1;
    std::tuple<double, int, int> its_key;
    for (int i = 0; i < he.size(); ++i) {
        int u = he[i].vi, v = he[he[i].opp].vi;
        Vec3 p = positions[std::size_t(v)];
        double error = value(quadrics[std::size_t(u)], p) +
                       value(quadrics[std::size_t(v)], p);
        std::tuple key(error, u, v);
        if ((best == -1 || key < its_key) && may_move(he, positions, i) &&
            can_collapse(he, i)) {
            best = i;
            its_key = key;
        }
    }
    return best;
}

}  // namespace

HalfEdgeTable simplify_quadric(const HalfEdgeTable& he, Positions positions,
                               int faces) {
    require(faces >= 0, "fewer than no faces");
    require_triangles_with_positions(he, positions);
    std::vector<Quadric> planes = quadrics(he, positions);
    HalfEdgeTable simpler = he;
    while (face_count(simpler) > faces) {
        int i = best_pull(simpler, positions, planes);
        if (i == -1) break;
        int u = simpler[i].vi, v = simpler[simpler[i].opp].vi;
        add(planes[std::size_t(v)], planes[std::size_t(u)]);
        simpler = collapse(simpler, i);
    }
    return simpler;
}
