#include "exercises/05_structures/winged_outgoing.h"

#include <algorithm>

#include "course/runner/suite.h"

using namespace course;

namespace {

using List = std::vector<DirectedEdge>;

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

/// The list, begun at its smallest element.
List from_smallest(List list) {
    std::rotate(list.begin(), std::min_element(list.begin(), list.end()),
                list.end());
    return list;
}

}  // namespace

TEST_CASE("the half-edges that leave the vertices of the slide mesh",
          "[points:2]") {
    hint("Which edge comes next round the vertex, and which way is it stored?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(from_smallest(winged_outgoing(slide_edges(), 2)) ==
          List{{0, true}, {2, false}, {5, false}, {6, false}});
    CHECK(from_smallest(winged_outgoing(slide_edges(), 1)) ==
          List{{1, false}, {3, false}, {2, true}});
    CHECK(from_smallest(winged_outgoing(slide_edges(), 3)) ==
          List{{6, true}, {7, true}});
}

TEST_CASE("nothing leaves a vertex without edges", "[points:1]") {
    hint("What does mesh.vertex[v] say about such a vertex?");
    WingedMesh mesh = slide_edges();
    mesh.vertex.push_back(-1);
    CHECK(winged_outgoing(mesh, 6).empty());
    CHECK(winged_outgoing(mesh, 4).size() == 2);
}
