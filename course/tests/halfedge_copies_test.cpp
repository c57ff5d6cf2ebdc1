// Many copies of a table, numbered in one mix.
#include <set>

#include "course/halfedge/build.h"
#include "course/halfedge/copies.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"

using namespace course;

namespace {

Copies copies_of(const Fixture& fixture, int count, std::uint64_t seed) {
    return {fixture.he.rows(), fixture.mesh.vertex_count(),
            fixture.mesh.faces.size(), count, seed};
}

/// Row i of copy c as the numbers say.
HalfEdge row_of(const Copies& copies, int i, int c) {
    const MixedNumbers half_edges(static_cast<int>(copies.tile.size()), copies);
    const HalfEdge& row = copies.tile[static_cast<std::size_t>(i)];
    return {MixedNumbers(copies.vertices, copies)(row.vi, c),
            MixedNumbers(copies.faces, copies)(row.fi, c),
            half_edges(row.next, c), half_edges(row.opp, c)};
}

}  // namespace

TEST_CASE("the table of many copies is valid, and each copy is the tile") {
    for (const Fixture& fixture : zoo::with_table())
        for (const int count : {1, 2, 7, 60}) {
            CAPTURE(fixture.name, count);
            const Copies copies = copies_of(fixture, count, 12345);
            const HalfEdgeTable he = table_of(copies);
            REQUIRE(he.size() == count * fixture.he.size());
            CHECK(validate(he).empty());
            const MixedNumbers numbers(fixture.he.size(), copies);
            for (int c = 0; c < count; ++c)
                for (int i = 0; i < fixture.he.size(); ++i)
                    REQUIRE(
                        he.rows()[static_cast<std::size_t>(numbers(i, c))] ==
                        row_of(copies, i, c));
        }
}

TEST_CASE("each number is given once, and other seeds give other numbers") {
    const Fixture fixture = zoo::slide();
    std::set<std::vector<int>> orders;
    for (const std::uint64_t seed : {0ull, 1ull, 999ull, 4294967295ull}) {
        const MixedNumbers numbers(fixture.he.size(),
                                   copies_of(fixture, 9, seed));
        std::vector<int> order;
        for (int i = 0; i < fixture.he.size(); ++i)
            for (int c = 0; c < 9; ++c) order.push_back(numbers(i, c));
        const std::set<int> all(order.begin(), order.end());
        CHECK(all.size() == order.size());
        CHECK(*all.begin() == 0);
        CHECK(*all.rbegin() == 9 * fixture.he.size() - 1);
        orders.insert(order);
    }
    CHECK(orders.size() == 4);
}

TEST_CASE("a million half-edges") {
    const IndexedMesh mesh = grid(25, 25);
    const Fixture tile{"grid", mesh, build(mesh)};
    const HalfEdgeTable he = table_of(copies_of(tile, 385, 77));
    CHECK(he.size() == 1'001'000);
    CHECK(validate(he).empty());
}

TEST_CASE("no copies, and copies of nothing, are an empty table") {
    CHECK(table_of(copies_of(zoo::slide(), 0, 1)).empty());
    CHECK(table_of(Copies{{}, 0, 0, 5, 1}).empty());
}
