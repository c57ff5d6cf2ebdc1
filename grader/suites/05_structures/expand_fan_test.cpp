// Hidden suite of expand_fan. Longer fans are expected to be what a fan is:
// triangles round one vertex, each sharing an edge with the one before.
#include "exercises/05_structures/expand_fan.h"

#include "grader/suites/05_structures/expanding.h"

using namespace course;
using hidden::are_triangles;

namespace {

/// The triangles round `hub` to the sides of the open polygon of the others,
/// without those that have a vertex twice.
std::vector<Tri> round_hub(int hub, const std::vector<int>& others) {
    std::vector<Tri> triangles;
    int last = hub;
    for (const int v : others) {
        if (last != hub && v != last && v != hub)
            triangles.push_back({last, v, hub});
        last = v;
    }
    return triangles;
}

std::vector<int> fan_of(int hub, std::vector<int> others) {
    others.insert(others.begin(), hub);
    return others;
}

}  // namespace

TEST_CASE("fans of different vertices, in order and winding", "[points:2]") {
    hint("Do neighbours run along their common edge in opposite directions?");
    CHECK_THAT(expand_fan({0, 1, 2}), are_triangles({{0, 1, 2}}));
    CHECK_THAT(expand_fan({2, 1, 0}), are_triangles({{2, 1, 0}}));
    CHECK_THAT(expand_fan({4, 9, 2, 7}), are_triangles({{4, 9, 2}, {4, 2, 7}}));
    CHECK_THAT(expand_fan({5, 0, 3, 1, 4, 2}),
               are_triangles({{5, 0, 3}, {5, 3, 1}, {5, 1, 4}, {5, 4, 2}}));
    CHECK_THAT(
        expand_fan({0, 2147483647, 1000000000, 3}),
        are_triangles({{0, 2147483647, 1000000000}, {0, 1000000000, 3}}));
    std::mt19937_64 random(seed());
    for (std::size_t n = 2; n < 200; ++n) {
        const std::vector<int> others = hidden::shuffled(n, random);
        REQUIRE_THAT(expand_fan(fan_of(static_cast<int>(n), others)),
                     are_triangles(round_hub(static_cast<int>(n), others)));
    }
}

TEST_CASE("a fan that closes round its first vertex", "[points:1]") {
    hint("May a vertex come back later in the list?");
    CHECK_THAT(expand_fan({6, 0, 1, 2, 3, 4, 5, 0}),
               are_triangles({{6, 0, 1},
                              {6, 1, 2},
                              {6, 2, 3},
                              {6, 3, 4},
                              {6, 4, 5},
                              {6, 5, 0}}));
    CHECK_THAT(expand_fan({9, 1, 2, 3, 1, 2}),
               are_triangles({{9, 1, 2}, {9, 2, 3}, {9, 3, 1}, {9, 1, 2}}));
}

TEST_CASE("triangles that have a vertex twice", "[points:1]") {
    hint("Which two of the three vertices can be the same? All pairs?");
    CHECK_THAT(expand_fan({0, 1, 1, 2}), are_triangles({{0, 1, 2}}));
    CHECK_THAT(expand_fan({0, 1, 2, 2, 2, 3}),
               are_triangles({{0, 1, 2}, {0, 2, 3}}));
    CHECK_THAT(expand_fan({0, 0, 1, 2}), are_triangles({{0, 1, 2}}));
    CHECK_THAT(expand_fan({0, 1, 2, 0, 3, 4}),
               are_triangles({{0, 1, 2}, {0, 3, 4}}));
    CHECK_THAT(expand_fan({0, 1, 2, 1}), are_triangles({{0, 1, 2}, {0, 2, 1}}));
    CHECK(expand_fan({5, 5, 5, 5}).empty());
    CHECK(expand_fan({5, 6, 5, 6}).empty());
    CHECK(expand_fan({0, 1, 0}).empty());
    std::mt19937_64 random(seed() + 1);
    for (std::size_t n = 2; n < 60; ++n) {
        const std::vector<int> others = hidden::random_list(n, 5, random);
        for (const int hub : {2, 7})
            REQUIRE_THAT(expand_fan(fan_of(hub, others)),
                         are_triangles(round_hub(hub, others)));
    }
}

TEST_CASE("lists that are too short", "[points:1]") {
    hint("What is the size of an empty list, minus two?");
    CHECK(expand_fan({}).empty());
    CHECK(expand_fan({0}).empty());
    CHECK(expand_fan({0, 1}).empty());
    CHECK(expand_fan({1, 1}).empty());
    CHECK(expand_fan({3, 1, 2}).size() == 1);
}
