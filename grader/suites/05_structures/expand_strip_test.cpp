// Hidden suite of expand_strip. Long strips are laid out in the plane, where
// all of their triangles must run counter-clockwise; short ones are written
// out.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <array>

#include "grader/suites/05_structures/expanding.h"

using namespace course;
using hidden::are_triangles;

namespace {

/// Twice the signed area of three vertices of the strip 0 1 2 ..., even ones in
/// the upper row, odd ones in the lower row, as in the picture.
int turn(int a, int b, int c) {
    const auto y = [](int v) { return v % 2 == 0 ? 1 : 0; };
    return (b - a) * (y(c) - y(a)) - (c - a) * (y(b) - y(a));
}

/// The triangles of the strip 0 1 2 ... n-1, counter-clockwise in the plane.
std::vector<Tri> in_the_plane(int n) {
    std::vector<Tri> triangles;
    for (int k = 0; k + 2 < n; ++k)
        triangles.push_back(turn(k, k + 1, k + 2) > 0 ? Tri{k, k + 1, k + 2}
                                                      : Tri{k + 2, k + 1, k});
    return triangles;
}

/// The same triangles with other vertices; those that get a vertex twice fall
/// out.
std::vector<Tri> with_vertices(std::vector<Tri> triangles,
                               const std::vector<int>& vertices) {
    for (Tri& t : triangles)
        for (int& v : t) v = vertices[static_cast<std::size_t>(v)];
    std::erase_if(triangles, [](const Tri& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
    return triangles;
}

void check(const std::vector<int>& strip) {
    const std::vector<Tri> expected =
        with_vertices(in_the_plane(static_cast<int>(strip.size())), strip);
    REQUIRE_THAT(expand_strip(strip), are_triangles(expected));
}

}  // namespace

TEST_CASE("strips of different vertices, in order and winding", "[points:2]") {
    hint("Do neighbours run along their common edge in opposite directions?");
    CHECK_THAT(expand_strip({0, 1, 2}), are_triangles({{0, 1, 2}}));
    CHECK_THAT(expand_strip({2, 1, 0}), are_triangles({{2, 1, 0}}));
    CHECK_THAT(expand_strip({4, 9, 2, 7}),
               are_triangles({{4, 9, 2}, {2, 9, 7}}));
    CHECK_THAT(expand_strip({5, 0, 3, 1, 4, 2}),
               are_triangles({{5, 0, 3}, {3, 0, 1}, {3, 1, 4}, {4, 1, 2}}));
    CHECK_THAT(expand_strip({0, 2147483647, 1000000000, 3}),
               are_triangles(
                   {{0, 2147483647, 1000000000}, {1000000000, 2147483647, 3}}));
    std::mt19937_64 random(seed());
    for (std::size_t n = 3; n < 200; ++n) check(hidden::shuffled(n, random));
}

TEST_CASE("two strips that are joined into one", "[points:1]") {
    hint("Does a triangle that is left out still have its place?");
    // Two vertices more: four triangles without area, and the winding stays.
    CHECK_THAT(expand_strip({0, 1, 2, 3, 3, 4, 4, 5, 6, 7}),
               are_triangles({{0, 1, 2}, {2, 1, 3}, {4, 5, 6}, {6, 5, 7}}));
    // Three more, and the second strip is the other way up.
    CHECK_THAT(expand_strip({0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7}),
               are_triangles({{0, 1, 2}, {2, 1, 3}, {4, 6, 5}, {5, 6, 7}}));
    // One more.
    CHECK_THAT(expand_strip({0, 1, 2, 2, 3}), are_triangles({{0, 1, 2}}));
    CHECK_THAT(expand_strip({0, 1, 2, 2, 3, 4, 5}),
               are_triangles({{0, 1, 2}, {4, 3, 2}, {3, 4, 5}}));
}

TEST_CASE("triangles that have a vertex twice", "[points:1]") {
    hint("Which two of the three vertices can be the same? All pairs?");
    // A vertex after two others again: one triangle has no area.
    CHECK_THAT(expand_strip({0, 1, 2, 1, 3}),
               are_triangles({{0, 1, 2}, {2, 1, 3}}));
    CHECK_THAT(expand_strip({0, 1, 0, 2, 3}),
               are_triangles({{0, 1, 2}, {0, 2, 3}}));
    CHECK_THAT(expand_strip({0, 0, 1, 2}), are_triangles({{0, 2, 1}}));
    CHECK_THAT(expand_strip({0, 1, 2, 0}),
               are_triangles({{0, 1, 2}, {0, 2, 1}}));
    CHECK_THAT(expand_strip({0, 1, 2, 2, 2, 3, 4}),
               are_triangles({{0, 1, 2}, {2, 3, 4}}));
    CHECK(expand_strip({5, 5, 5, 5, 5}).empty());
    CHECK(expand_strip({5, 6, 5, 6, 5}).empty());
    CHECK(expand_strip({5, 5, 6, 6}).empty());
    CHECK(expand_strip({0, 1, 0}).empty());
}

TEST_CASE("any list of vertices", "[points:1]") {
    hint(
        "What tells how a triangle is wound, and what has nothing to do with "
        "it?");
    std::mt19937_64 random(seed() + 1);
    for (std::size_t n = 3; n < 80; ++n)
        for (const std::uint64_t below : {3U, 6U, 40U})
            check(hidden::random_list(n, below, random));
}

TEST_CASE("lists that are too short", "[points:1]") {
    hint("What is the size of an empty list, minus two?");
    CHECK(expand_strip({}).empty());
    CHECK(expand_strip({0}).empty());
    CHECK(expand_strip({0, 1}).empty());
    CHECK(expand_strip({1, 1}).empty());
    CHECK(expand_strip({3, 1, 2}).size() == 1);
}
