#include "exercises/05_structures/winged_faces.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The slide mesh as winged edges: each field is as course/mesh/winged.h says.
//      1--e3---4
//     /|       |       e0 from 2 to 0     e4 from 4 to 5
//   e1 |   F1  |       e1 from 0 to 1     e5 from 5 to 2
//   /F0|       e4      e2 from 1 to 2     e6 from 3 to 2
//  0   e2      |       e3 from 4 to 1     e7 from 3 to 5
//   \  |       |
//   e0 |       |
//     \|       |
//      2--e5---5
//       \  F2 /
//       e6  e7
//         \/
//          3
WingedMesh slide_edges() {
    return {{{2, 0, -1, 0, 6, 2, 1, 1},
             {0, 1, -1, 0, 0, 0, 3, 2},
             {1, 2, 1, 0, 3, 1, 5, 0},
             {4, 1, 1, -1, 4, 4, 2, 1},
             {4, 5, -1, 1, 3, 3, 7, 5},
             {5, 2, 2, 1, 7, 4, 6, 2},
             {3, 2, -1, 2, 7, 7, 0, 5},
             {3, 5, 2, -1, 6, 6, 5, 4}},
            {0, 3, 6, 7, 3, 7},
            {2, 5, 6}};
}

}  // namespace

TEST_CASE("the faces at vertex 2 of the slide mesh", "[points:1]") {
    hint("Which edges at vertex 2 leave it, and which arrive?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(winged_faces(slide_edges(), 2), IsPermutationOf({0, 1, 2}));
}

TEST_CASE("vertices of the slide mesh with fewer faces", "[points:1]") {
    hint("What is on the other side of an edge on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(winged_faces(slide_edges(), 0), IsPermutationOf({0}));
    CHECK_THAT(winged_faces(slide_edges(), 1), IsPermutationOf({0, 1}));
    CHECK_THAT(winged_faces(slide_edges(), 3), IsPermutationOf({2}));
    CHECK_THAT(winged_faces(slide_edges(), 4), IsPermutationOf({1}));
    CHECK_THAT(winged_faces(slide_edges(), 5), IsPermutationOf({1, 2}));
}

TEST_CASE("a vertex without edges has no faces", "[points:1]") {
    hint("What does mesh.vertex[v] say about such a vertex?");
    WingedMesh mesh = slide_edges();
    mesh.vertex.push_back(-1);
    CHECK(winged_faces(mesh, 6).empty());
    CHECK_THAT(winged_faces(mesh, 4), IsPermutationOf({1}));
}
