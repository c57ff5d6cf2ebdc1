// The mesh zoo. Each fixture is written by hand; the comment above it shows its
// vertices and faces, the counts, and the Euler characteristic chi = V - E + F.
// "Loops" are the closed walks along the border.
#include "course/mesh/zoo.h"

#include <utility>

#include "course/halfedge/build.h"

namespace course::zoo {

namespace {

Fixture built(std::string name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

Fixture without_table(std::string name, IndexedMesh mesh) {
    return {std::move(name), std::move(mesh), {}};
}

std::vector<Vec3> house_positions() {
    return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0},       {0, 0, 1},
            {0, 1, 1}, {1, 0, 1}, {1, 1, 1}, {0.5, 0.5, 1.75}};
}

// bow-tie: two triangles that share one vertex      3         2
//   F0 = (0,1,2)                                    |\       /|
//   F1 = (0,3,4)                                    | \     / |
//   V 5, E 6, F 2, chi 1                            |  \   /  |
// Two border half-edges arrive at 0 and two leave   | F1 0 F0 |
// it, and which follows which is free: that is      |  /   \  |
// the difference between the two fixtures.          | /     \ |
//                                                   |/       \|
//                                                   4         1
IndexedMesh bow_tie_mesh() {
    return {{{0, 0}, {2, -1.5}, {2, 1.5}, {-2, 1.5}, {-2, -1.5}},
            {{0, 1, 2}, {0, 3, 4}},
            {}};
}

/// Half-edges 6 and 9 arrive at vertex 0 on the border; 8 and 11 leave it.
HalfEdgeTable bow_tie_table(int next_of_6, int next_of_9) {
    return {{0, 0, 1, 6},          {1, 0, 2, 7},  {2, 0, 0, 8},
            {0, 1, 4, 9},          {3, 1, 5, 10}, {4, 1, 3, 11},
            {1, -1, next_of_6, 0}, {2, -1, 6, 1}, {0, -1, 7, 2},
            {3, -1, next_of_9, 3}, {4, -1, 9, 4}, {0, -1, 10, 5}};
}

}  // namespace

// slide: the worked table, with positions of our own          1-------4
//   F0 = (0,2,1)                                             /|       |
//   F1 = (1,2,5,4)                                          / |       |
//   F2 = (2,3,5)                                           0F0|  F1   |
//   V 6, E 8, F 3, chi 1, 1 loop: 2-0-1-4-5-3               \ |       |
// The rows are those of the lecture (slides 159-164),        \|       |
// not the builder's: opposites do not lie side by side.       2-------5
//                                                              \ F2  /
//                                                               \  /
//                                                                3
Fixture slide() {
    return {"slide",
            {{{0, 0}, {1, 1}, {1, -1}, {1.5, -2}, {2, 1}, {2, -1}},
             {{0, 2, 1}, {1, 2, 5, 4}, {2, 3, 5}},
             {}},
            {{2, -1, 2, 1},
             {0, 0, 3, 0},
             {0, -1, 6, 5},
             {2, 0, 5, 4},
             {1, 1, 11, 3},
             {1, 0, 1, 2},
             {1, -1, 7, 12},
             {4, -1, 10, 15},
             {5, 2, 14, 11},
             {3, 2, 8, 10},
             {5, -1, 13, 9},
             {2, 1, 15, 8},
             {4, 1, 4, 6},
             {3, -1, 0, 14},
             {2, 2, 9, 13},
             {5, 1, 12, 7}}};
}

// triangle: the smallest mesh with a border          2
//   F0 = (0,1,2)                                    / \.
//   V 3, E 3, F 1, chi 1, 1 loop                   / F0\.
//                                                 0-----1
Fixture triangle() {
    return built("triangle", {{{0, 0}, {2, 0}, {1, 1.75}}, {{0, 1, 2}}, {}});
}

// tetra: alternate corners of a cube                      3-------1
//   F0 = (1,2,3)  F1 = (1,0,2)                            |\    . |
//   F2 = (3,2,0)  F3 = (0,1,3)                            |  \.   |
//   V 4, E 6, F 4, chi 2, no loop                         | .  \  |
// As the lecture's OFF example has it, inside out: the    |.     \|
// signed volume is -8/3. (Seen from +z; 0-1 is behind.)   0-------2
Fixture tetra() {
    return built("tetra", {{{-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}},
                           {{1, 2, 3}, {1, 0, 2}, {3, 2, 0}, {0, 1, 3}},
                           {}});
}

// cube: six quads; vertices 0..3 below, 4..7 above         5-------7
//   F0 = (0,2,6,4)  F1 = (0,1,3,2)  F2 = (2,3,7,6)        /|      /|
//   F3 = (4,6,7,5)  F4 = (0,4,5,1)  F5 = (1,5,7,3)       4-------6 |
//   V 8, E 12, F 6, chi 2, no loop                       | 1-----|-3
//                                                        |/      |/
//                                                        0-------2
Fixture cube() {
    std::vector<Vec3> positions = house_positions();
    positions.pop_back();
    return built("cube", {std::move(positions),
                          {{0, 2, 6, 4},
                           {0, 1, 3, 2},
                           {2, 3, 7, 6},
                           {4, 6, 7, 5},
                           {0, 4, 5, 1},
                           {1, 5, 7, 3}},
                          {}});
}

// house: the cube with a roof in place of its lid               8
//   F0 = (0,2,6,4)  F1 = (0,1,3,2)  F2 = (2,3,7,6)            / /\ \.
//   F3 = (0,4,5,1)  F4 = (1,5,7,3)                           / 5--\-7
//   F5 = (7,8,6)  F6 = (5,8,7)  F7 = (4,8,5)  F8 = (6,8,4)  / /    \/|
//   V 9, E 16, F 9, chi 2, no loop                         4-------6 |
//                                                          | 1-----|-3
//                                                          |/      |/
//                                                          0-------2
Fixture house() {
    return built("house", {house_positions(),
                           {{0, 2, 6, 4},
                            {0, 1, 3, 2},
                            {2, 3, 7, 6},
                            {0, 4, 5, 1},
                            {1, 5, 7, 3},
                            {7, 8, 6},
                            {5, 8, 7},
                            {4, 8, 5},
                            {6, 8, 4}},
                           {}});
}

// annulus: three quads in a ring                     2
//   F0 = (0,1,4,3)                                  /|\.
//   F1 = (1,2,5,4)                                 / 5 \.
//   F2 = (2,0,3,5)                             F2 / / \ \ F1
//   V 6, E 9, F 3, chi 0, 2 loops                / /   \ \.
//                                               / 3-----4 \.
//                                              / /  F0   \ \.
//                                             0-------------1
Fixture annulus() {
    return built(
        "annulus",
        {{{-3, -2}, {3, -2}, {0, 4}, {-0.9, -0.6}, {0.9, -0.6}, {0, 1.2}},
         {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
         {}});
}

// moebius3q: the annulus cut between F2 and F0    3------4------5------0
// and glued again with half a turn                |  F0  |  F1  |  F2  |
//   F0 = (0,1,4,3)                                0------1------2------3
//   F1 = (1,2,5,4)
//   F2 = (2,3,0,5)
//   V 6, E 9, F 3, chi 0, 1 loop: V, E and F of the annulus, but F0 and F2
//   run along the edge 0-3 alike: no table
Fixture moebius3q() {
    return without_table("moebius3q",
                         {{{3, 0, 0},
                           {-1.25, 2.25, 0.75},
                           {-0.75, -1.25, 0.75},
                           {1, 0, 0},
                           {-0.75, 1.25, -0.75},
                           {-1.25, -2.25, -0.75}},
                          {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}},
                          {}});
}

// moebius5: five triangles in a ring with a twist        0-----2-----4-----1
//   F0 = (0,1,2)  F1 = (1,2,3)  F2 = (2,3,4)              \ F0/ \ F2/ \ F4/
//   F3 = (3,4,0)  F4 = (4,0,1)                             \ / F1\ / F3\ /
//   V 5, E 10, F 5, chi 0, 1 loop; no table                 1-----3-----0
Fixture moebius5() {
    return without_table(
        "moebius5",
        {{{-2, -1, 0}, {2, -1, 0}, {0.5, 0.5, 1.5}, {0, 2, 0}, {-0.5, 0, -1.5}},
         {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}},
         {}});
}

// torus7: the torus with the fewest vertices, each         3-----4-----5-----6
// of them next to each other one                          / \ F8/ \ F9/ \F10/
//   Fi   = (i, i+1, i+3) mod 7, i = 0..6                 / F0\ / F1\ / F2\ /
//   Fi+7 = (i, i+3, i+2) mod 7                          0-----1-----2-----3
//   V 7, E 21, F 14, chi 0 (genus 1), no loop
// The positions turn into themselves by half a turn round z, i -> -i mod 7,
// and no two faces cut each other.
Fixture torus7() {
    IndexedMesh mesh{{{0, 0, -3},
                      {4, -4, -1},
                      {3, -2, 4},
                      {4, 1, -4},
                      {-4, -1, -4},
                      {-3, 2, 4},
                      {-4, 4, -1}},
                     {},
                     {}};
    for (int i = 0; i < 7; ++i)
        mesh.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    for (int i = 0; i < 7; ++i)
        mesh.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
    return built("torus7", std::move(mesh));
}

// klein4x4: a grid of quads, glued bottom to top as     3----7---11---15----0
// a tube, and left to right upside down                 | F2 | F6 |F10 |F14 |
//   vertex 4i+j stands in column i, row j; F4i+j        2----6---10---14----1
//   is the quad to its upper right                      | F1 | F5 | F9 |F13 |
//   V 16, E 32, F 16, chi 0, no loop; no table          1----5----9---13----2
// F3, F7, F11 and F15 join row 3 to row 0. In space     | F0 | F4 | F8 |F12 |
// the tube's section is an eight that makes half a      0----4----8---12----3
// turn on its way round: it cuts itself.
Fixture klein4x4() {
    IndexedMesh mesh{{{3.75, 0, 1},
                      {3.75, 0, -1},
                      {2.25, 0, 1},
                      {2.25, 0, -1},
                      {0, 2.75, 1.25},
                      {0, 4.25, -0.25},
                      {0, 1.75, 0.25},
                      {0, 3.25, -1.25},
                      {-2, 0, 0.75},
                      {-4, 0, 0.75},
                      {-2, 0, -0.75},
                      {-4, 0, -0.75},
                      {0, -1.75, -0.25},
                      {0, -3.25, 1.25},
                      {0, -2.75, -1.25},
                      {0, -4.25, 0.25}},
                     {},
                     {}};
    const auto vertex = [](int i, int j) { return i < 4 ? 4 * i + j : 3 - j; };
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const int above = (j + 1) % 4;
            mesh.faces.push_back({vertex(i, j), vertex(i + 1, j),
                                  vertex(i + 1, above), vertex(i, above)});
        }
    return without_table("klein4x4", std::move(mesh));
}

// rp2_6: the projective plane with the fewest vertices,      1---------5
// half an icosahedron                                       / \  F4   / \.
//   F0 = (0,1,2)  F1 = (0,2,3)  F2 = (0,3,4)               / F0 \   / F3 \.
//   F3 = (0,4,5)  F4 = (0,5,1)                            2-------0-------4
//   F5 = (1,2,4)  F6 = (2,3,5)  F7 = (3,4,1)               \  F1  |  F2  /
//   F8 = (4,5,2)  F9 = (5,1,3)                               \    |    /
//   V 6, E 15, F 10, chi 1, no loop; no table                  \  |  /
// F5..F9 close the rim 1-2-3-4-5 behind, each with               \|/
// the opposite vertex of the rim.                                 3
Fixture rp2_6() {
    return without_table("rp2_6", {{{0, 0, 1},
                                    {-1.25, 1.75, 0},
                                    {-2, -0.75, 0},
                                    {0, -2, 0},
                                    {2, -0.75, 0},
                                    {1.25, 1.75, 0}},
                                   {{0, 1, 2},
                                    {0, 2, 3},
                                    {0, 3, 4},
                                    {0, 4, 5},
                                    {0, 5, 1},
                                    {1, 2, 4},
                                    {2, 3, 5},
                                    {3, 4, 1},
                                    {4, 5, 2},
                                    {5, 1, 3}},
                                   {}});
}

// pillow: two triangles, front and back, glued along     2
// all three edges                                       / \.
//   F0 = (0,1,2)                                       /F0 \.
//   F1 = (0,2,1)                                      / (F1 \.
//   V 3, E 3, F 2, chi 2, no loop                    / behind)\.
//                                                   0-----------1
Fixture pillow() {
    return built("pillow",
                 {{{0, 0}, {2, 0}, {1, 1.75}}, {{0, 1, 2}, {0, 2, 1}}, {}});
}

// lens: two quads that share the edges 2-3 and 3-0         2
//   F0 = (0,1,2,3)                                        /|\.
//   F1 = (0,3,2,4)                                       / | \.
//   V 5, E 6, F 2, chi 1, 1 loop                        /  |  \.
// Two shared edges, but one adjacent face.             4 F13 F0 1
//                                                       \  |  /
//                                                        \ | /
//                                                         \|/
//                                                          0
Fixture lens() {
    return built("lens", {{{0, -2}, {1.5, 0}, {0, 2}, {0, 0}, {-1.5, 0}},
                          {{0, 1, 2, 3}, {0, 3, 2, 4}},
                          {}});
}

// fan6: six triangles round the interior vertex 0        3-----2
//   Fi = (0, i+1, i+2), i = 0..4, F5 = (0,6,1)          / \F1 / \.
//   V 7, E 12, F 6, chi 1, 1 loop                      /F2 \ /F0 \.
//                                                     4-----0-----1
//                                                      \F3 / \F5 /
//                                                       \ /F4 \ /
//                                                        5-----6
Fixture fan6() {
    return built(
        "fan6",
        {{{0, 0},
          {2, 0},
          {1, 1.75},
          {-1, 1.75},
          {-2, 0},
          {-1, -1.75},
          {1, -1.75}},
         {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}},
         {}});
}

// two_triangles: two components                     2         5
//   F0 = (0,1,2)                                   / \       / \.
//   F1 = (3,4,5)                                  / F0\     / F1\.
//   V 6, E 6, F 2, chi 2, 2 loops                0-----1   3-----4
Fixture two_triangles() {
    return built("two_triangles",
                 {{{0, 0}, {2, 0}, {1, 1.75}, {3, 0}, {5, 0}, {4, 1.75}},
                  {{0, 1, 2}, {3, 4, 5}},
                  {}});
}

// dangling: the slide mesh with an edge that has no                6
// face on either side                                             /
//   F0, F1, F2 as in slide; loose edge 4-6              1-------4
//   V 7, E 9, F 3, chi 1, 1 loop of 8 half-edges:      /|       |
//   2-0-1-4-6-4-5-3                                   0 |       |
// The rows 0..15 are those of slide, but for the       \|       |
// `next` of row 6.                                      2-------5
//                                                        \     /
//                                                          \ /
//                                                           3
Fixture dangling() {
    Fixture fixture = slide();
    fixture.name = "dangling";
    fixture.mesh.positions.push_back({3, 2});
    fixture.mesh.loose_edges.push_back({4, 6});
    fixture.he = add_dangling_edge(fixture.he, 6, 6);
    return fixture;
}

// bow_tie_crossed: at vertex 0 the border changes over to the other triangle:
// 1 loop of six half-edges, and a walk round 0 meets all four neighbours.
Fixture bow_tie_crossed() {
    return {"bow_tie_crossed", bow_tie_mesh(), bow_tie_table(11, 8)};
}

// bow_tie_separate: at vertex 0 the border stays with its triangle: 2 loops of
// three, and a walk round 0 meets only the two neighbours on its own side.
Fixture bow_tie_separate() {
    return {"bow_tie_separate", bow_tie_mesh(), bow_tie_table(8, 11)};
}

// hourglass: two tetrahedra that share vertex 0          5-----4
//   F0 = (0,1,2)  F1 = (0,2,3)  F2 = (0,3,1)              \ 6 /
//   F3 = (1,3,2)                                           \|/
//   F4 = (0,5,4)  F5 = (0,6,5)  F6 = (0,4,6)                0
//   F7 = (4,5,6)                                           /|\.
//   V 7, E 12, F 8, chi 3, no loop                        / 3 \.
// No border, so each tetrahedron has a fan of its own    2-----1
// at 0, and a walk round 0 meets only one of them.
Fixture hourglass() {
    return built("hourglass", {{{0, 0, 0},
                                {2, 0, -2},
                                {-1, 1.75, -2},
                                {-1, -1.75, -2},
                                {2, 0, 2},
                                {-1, 1.75, 2},
                                {-1, -1.75, 2}},
                               {{0, 1, 2},
                                {0, 2, 3},
                                {0, 3, 1},
                                {1, 3, 2},
                                {0, 5, 4},
                                {0, 6, 5},
                                {0, 4, 6},
                                {4, 5, 6}},
                               {}});
}

// fan3: three pages on the edge 0-1, like a book         1
//   F0 = (0,1,2)                                        /|\\.
//   F1 = (1,0,3)                                       / | \ \.
//   F2 = (0,1,4)                                      3  |  2 4
//   V 5, E 7, F 3, chi 1; no table                     \ | / /
//                                                       \|//
//                                                        0
Fixture fan3() {
    return without_table("fan3", {{{0, -1, 0},
                                   {0, 1, 0},
                                   {2, 0, 0},
                                   {-1.5, 0.5, 1.5},
                                   {-1.5, -0.5, -1.5}},
                                  {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                                  {}});
}

// house_with_wall: the house with the lid of the cube left in, as a ceiling
//   F3 = (4,6,7,5), the others follow in the order of house
//   V 9, E 16, F 10, chi 3; three faces each at the edges 4-6, 6-7, 7-5 and
//   5-4: no table
Fixture house_with_wall() {
    return without_table("house_with_wall", {house_positions(),
                                             {{0, 2, 6, 4},
                                              {0, 1, 3, 2},
                                              {2, 3, 7, 6},
                                              {4, 6, 7, 5},
                                              {0, 4, 5, 1},
                                              {1, 5, 7, 3},
                                              {7, 8, 6},
                                              {5, 8, 7},
                                              {4, 8, 5},
                                              {6, 8, 4}},
                                             {}});
}

std::vector<Fixture> with_table() {
    return {slide(),
            triangle(),
            tetra(),
            cube(),
            house(),
            annulus(),
            torus7(),
            pillow(),
            lens(),
            fan6(),
            two_triangles(),
            dangling(),
            bow_tie_crossed(),
            bow_tie_separate(),
            hourglass()};
}

}  // namespace course::zoo
