// The text of a table, as people read it.
#include "course/halfedge/describe.h"

#include <algorithm>
#include <climits>
#include <string>

#include "course/halfedge/build.h"
#include "course/runner/catch2.h"

namespace course {

namespace {

HalfEdgeTable slide() {
    return {{2, -1, 2, 1},  {0, 0, 3, 0},   {0, -1, 6, 5},  {2, 0, 5, 4},
            {1, 1, 11, 3},  {1, 0, 1, 2},   {1, -1, 7, 12}, {4, -1, 10, 15},
            {5, 2, 14, 11}, {3, 2, 8, 10},  {5, -1, 13, 9}, {2, 1, 15, 8},
            {4, 1, 4, 6},   {3, -1, 0, 14}, {2, 2, 9, 13},  {5, 1, 12, 7}};
}

/// 25 edges that hang together, 50 half-edges.
HalfEdgeTable chain() {
    IndexedMesh mesh;
    mesh.positions.resize(26);
    for (int v = 0; v < 25; ++v) mesh.loose_edges.push_back({v, v + 1});
    return build(mesh);
}

std::string last_line(const HalfEdgeTable& he) {
    const std::string text = describe(he);
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

}  // namespace

TEST_CASE("the slide's table reads as on the slide") {
    CHECK("\n" + describe(slide()) == R"(
    vi  fi  next  opp
 0   2   -     2    1
 1   0   0     3    0
 2   0   -     6    5
 3   2   0     5    4
 4   1   1    11    3
 5   1   0     1    2
 6   1   -     7   12
 7   4   -    10   15
 8   5   2    14   11
 9   3   2     8   10
10   5   -    13    9
11   2   1    15    8
12   4   1     4    6
13   3   -     0   14
14   2   2     9   13
15   5   1    12    7
6 vertices, 8 edges, 3 faces, 1 border loop
)");
}

TEST_CASE("marked rows have a sign before them") {
    const HalfEdgeTable he = {{0, -1, 1, 1}, {1, -1, 0, 0}};
    CHECK("\n" + describe(he, {1, 1'000'000'000, -1}) == R"(
    vi  fi  next  opp
 0   0   -     1    1
>1   1   -     0    0
2 vertices, 1 edge, 0 faces, 1 border loop
)");
}

TEST_CASE("a large table is cut in the middle, and says so") {
    const std::string text = describe(chain());
    CHECK(text.find("\n23  ") != std::string::npos);
    CHECK(text.find("\n24  ") == std::string::npos);
    CHECK(text.find("\n... 2 rows left out\n26  ") != std::string::npos);
    CHECK(text.find("\n49  ") != std::string::npos);
    CHECK(text.find("\n26 vertices, 25 edges, 0 faces, 1 border loop\n") !=
          std::string::npos);
}

TEST_CASE("a marked row is shown where others are left out") {
    const std::string text = describe(chain(), {25});
    CHECK(text.find("\n... 1 row left out\n>25  ") != std::string::npos);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 49 + 1 + 1);
}

TEST_CASE("the largest table that is shown whole has 48 rows") {
    HalfEdgeTable he;
    for (int i = 0; i < 48; ++i) he.push_back({i, -1, i ^ 1, i ^ 1});
    CHECK(describe(he).find("left out") == std::string::npos);
    he.push_back({48, -1, 48, 48});
    CHECK(describe(he).find("... 1 row left out") != std::string::npos);
}

TEST_CASE("an empty table has a heading and no rows") {
    CHECK(describe({}) ==
          "  vi  fi  next  opp\n"
          "0 vertices, 0 edges, 0 faces, 0 border loops\n");
}

TEST_CASE("any numbers may stand in the table") {
    const HalfEdgeTable he = {
        {-2, INT_MAX, 77, -1}, {INT_MIN, -1, 1, 0}, {0, -1, 1, 3}};
    CHECK("\n" + describe(he) == R"(
            vi          fi  next  opp
0           -2  2147483647    77    -
1  -2147483648           -     1    0
2            0           -     1    3
1 vertex, 1 edge, 1 face, 1 border loop
)");
}

TEST_CASE("border loops are counted each on its own") {
    IndexedMesh mesh;  // an annulus of three quads, and an edge apart
    mesh.positions.resize(8);
    mesh.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    CHECK(last_line(build(mesh)) ==
          "6 vertices, 9 edges, 3 faces, 2 border loops\n");
    mesh.loose_edges = {{6, 7}};
    CHECK(last_line(build(mesh)) ==
          "8 vertices, 10 edges, 3 faces, 3 border loops\n");
}

}  // namespace course
