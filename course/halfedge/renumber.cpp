// Random renumbering of a half-edge table.
#include "course/halfedge/renumber.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace course {

namespace {

/// 0..n-1 in random order. std::shuffle may differ from library to library;
/// the generator itself may not. (Fisher and Yates)
std::vector<int> random_order(std::size_t n, std::mt19937_64& random) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t left = n; left > 1; --left)
        std::swap(order[left - 1], order[random() % left]);
    return order;
}

int renamed(const std::vector<int>& names, int old) {
    if (old < 0 || static_cast<std::size_t>(old) >= names.size()) return old;
    return names[static_cast<std::size_t>(old)];
}

HalfEdgeTable with_names(const HalfEdgeTable& he, const Renumbering& names) {
    std::vector<HalfEdge> rows(he.rows().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const HalfEdge& row = he.rows()[i];
        rows[static_cast<std::size_t>(names.half_edge[i])] = {
            renamed(names.vertex, row.vi), renamed(names.face, row.fi),
            renamed(names.half_edge, row.next),
            renamed(names.half_edge, row.opp)};
    }
    return HalfEdgeTable(std::move(rows));
}

}  // namespace

HalfEdgeTable renumber(const HalfEdgeTable& he, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Renumbering names;
    names.half_edge = random_order(he.rows().size(), random);
    return with_names(he, names);
}

Renumbering renumber_all(const HalfEdgeTable& he, std::uint64_t seed) {
    int vertices = 0;
    int faces = 0;
    for (const HalfEdge& row : he.rows()) {
        vertices = std::max(vertices, row.vi + 1);
        faces = std::max(faces, row.fi + 1);
    }
    std::mt19937_64 random(seed);
    Renumbering result;
    result.half_edge = random_order(he.rows().size(), random);
    result.vertex = random_order(static_cast<std::size_t>(vertices), random);
    result.face = random_order(static_cast<std::size_t>(faces), random);
    result.he = with_names(he, result);
    return result;
}

}  // namespace course
