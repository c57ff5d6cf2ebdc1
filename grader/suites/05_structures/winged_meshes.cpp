#include "grader/suites/05_structures/winged_meshes.h"

#include <algorithm>
#include <random>

#include "course/runner/suite.h"

namespace course::hidden {

namespace {

using Rows = std::vector<HalfEdge>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

std::array<int, 2> ends(const Rows& rows, const HalfEdge& row) {
    return {row.vi, rows[at(row.opp)].vi};
}

std::vector<int> previous(const Rows& rows) {
    std::vector<int> prev(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        prev[at(rows[i].next)] = static_cast<int>(i);
    return prev;
}

/// One half-edge of each edge, in random order.
std::vector<int> one_of_each(const Rows& rows, std::mt19937_64& random) {
    std::vector<int> forward;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<int>(i) < rows[i].opp)
            forward.push_back(random() % 2 == 0 ? static_cast<int>(i)
                                                : rows[i].opp);
    for (std::size_t k = forward.size(); k > 1; --k)
        std::swap(forward[k - 1], forward[random() % k]);
    return forward;
}

/// Sets element k, or leaves it, so that each of many values has a chance.
void set(std::vector<int>& list, int k, int value, std::mt19937_64& random) {
    if (k < 0) return;
    if (list[at(k)] == -1 || random() % 2 == 0) list[at(k)] = value;
}

}  // namespace

Sides sides_of(const Fixture& fixture) {
    Sides sides;
    for (int f = 0; f < fixture.mesh.faces.size(); ++f) {
        const auto face = fixture.mesh.faces[f];
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k)
            sides[{face[k], face[(k + 1) % n]}] = {f, face[(k + n - 1) % n],
                                                   face[(k + 2) % n]};
    }
    const Rows& rows = fixture.he.rows();
    const std::vector<int> prev = previous(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const HalfEdge& next = rows[at(rows[i].next)];
        sides.insert({ends(rows, rows[i]),
                      {rows[i].fi, rows[at(prev[i])].vi, ends(rows, next)[1]}});
    }
    return sides;
}

WingedFixture winged_fixture(const Fixture& fixture, std::uint64_t salt) {
    const Rows& rows = fixture.he.rows();
    std::mt19937_64 random(seed() * 1000 + salt);
    const std::vector<int> forward = one_of_each(rows, random);
    WingedFixture made;
    made.directed.resize(rows.size());
    for (std::size_t k = 0; k < forward.size(); ++k) {
        made.directed[at(forward[k])] = {static_cast<int>(k), true};
        made.directed[at(rows[at(forward[k])].opp)] = {static_cast<int>(k),
                                                       false};
    }
    made.mesh.vertex.assign(fixture.mesh.positions.size(), -1);
    made.mesh.face.assign(at(fixture.mesh.faces.size()), -1);
    const std::vector<int> prev = previous(rows);
    const auto edge = [&](int i) { return made.directed[at(i)].edge; };
    for (const int i : forward) {
        const HalfEdge& left = rows[at(i)];
        const HalfEdge& right = rows[at(left.opp)];
        const int e = static_cast<int>(made.mesh.edges.size());
        made.mesh.edges.push_back({left.vi, right.vi, left.fi, right.fi,
                                   edge(prev[at(i)]), edge(right.next),
                                   edge(left.next), edge(prev[at(left.opp)])});
        for (const HalfEdge& side : {left, right}) {
            set(made.mesh.vertex, side.vi, e, random);
            set(made.mesh.face, side.fi, e, random);
        }
    }
    return made;
}

}  // namespace course::hidden
