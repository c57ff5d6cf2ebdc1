// Renumbering keeps the mesh and changes the numbers, alike everywhere.
#include "course/halfedge/renumber.h"

#include <algorithm>
#include <climits>
#include <set>
#include <vector>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"

namespace course {

namespace {

bool is_permutation(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k] != static_cast<int>(k)) return false;
    return true;
}

int name(const std::vector<int>& names, int old) {
    return old == -1 ? -1 : names[static_cast<std::size_t>(old)];
}

HalfEdgeTable triangle() {
    return {{0, 0, 1, 3},  {1, 0, 2, 4},  {2, 0, 0, 5},
            {1, -1, 5, 0}, {2, -1, 3, 1}, {0, -1, 4, 2}};
}

}  // namespace

TEST_CASE("every row is found under its new numbers") {
    Random random(40);
    for (int round = 0; round < 500; ++round) {
        const HalfEdgeTable he = build(random_sound_mesh(random));
        const Renumbering r = renumber_all(he, random());
        REQUIRE(r.he.size() == he.size());
        REQUIRE(is_permutation(r.half_edge));
        REQUIRE(is_permutation(r.vertex));
        REQUIRE(is_permutation(r.face));
        for (int i = 0; i < he.size(); ++i) {
            const HalfEdge old = he[i];
            REQUIRE(r.he[name(r.half_edge, i)] ==
                    HalfEdge{name(r.vertex, old.vi), name(r.face, old.fi),
                             name(r.half_edge, old.next),
                             name(r.half_edge, old.opp)});
        }
        REQUIRE(validate(r.he).empty());
    }
}

TEST_CASE("renumber keeps vertices and faces, and agrees with renumber_all") {
    const HalfEdgeTable he = triangle();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const HalfEdgeTable other = renumber(he, seed);
        const Renumbering all = renumber_all(he, seed);
        for (int i = 0; i < he.size(); ++i) {
            const int j = name(all.half_edge, i);
            CHECK(other[j].vi == he[i].vi);
            CHECK(other[j].fi == he[i].fi);
            CHECK(other[j].next == name(all.half_edge, he[i].next));
            CHECK(other[j].opp == name(all.half_edge, he[i].opp));
        }
    }
}

TEST_CASE("every order comes up") {
    std::set<std::vector<int>> orders;
    for (std::uint64_t seed = 0; seed < 20'000; ++seed)
        orders.insert(renumber_all(triangle(), seed).half_edge);
    CHECK(orders.size() == 720);
}

TEST_CASE("the same seed gives the same numbers on every platform") {
    CHECK(renumber(triangle(), 1) == renumber(triangle(), 1));
    const Renumbering r = renumber_all(triangle(), 2021);
    CHECK(r.half_edge == std::vector{5, 2, 0, 3, 4, 1});
    CHECK(r.vertex == std::vector{2, 0, 1});
}

TEST_CASE("numbers that are no rows stay as they are") {
    const HalfEdgeTable he = {{-5, -7, 99, INT_MIN}, {0, 0, 0, INT_MAX}};
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const HalfEdgeTable other = renumber(he, seed);
        const int first = other[0].vi == -5 ? 0 : 1;
        CHECK(other[first] == HalfEdge{-5, -7, 99, INT_MIN});
        CHECK(other[1 - first] == HalfEdge{0, 0, first, INT_MAX});
    }
}

TEST_CASE("an empty table stays empty") {
    CHECK(renumber({}, 3).empty());
    CHECK(renumber_all({}, 3).half_edge.empty());
}

}  // namespace course
