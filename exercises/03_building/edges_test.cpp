#include "exercises/03_building/edges.h"

#include <algorithm>
#include <tuple>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The smaller end first, and the edges in order.
std::vector<EdgeInfo> in_order(std::vector<EdgeInfo> list) {
    for (EdgeInfo& edge : list)
        if (edge.a > edge.b) std::swap(edge.a, edge.b);
    std::sort(list.begin(), list.end(), [](EdgeInfo x, EdgeInfo y) {
        return std::tie(x.a, x.b, x.faces) < std::tie(y.a, y.b, y.faces);
    });
    return list;
}

}  // namespace

TEST_CASE("the slide mesh has eight edges", "[points:1]") {
    hint("Is the side from 1 to 2 another edge than the one from 2 to 1?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(in_order(edges(slide.mesh)) == std::vector<EdgeInfo>{{0, 1, 1},
                                                               {0, 2, 1},
                                                               {1, 2, 2},
                                                               {1, 4, 1},
                                                               {2, 3, 1},
                                                               {2, 5, 2},
                                                               {3, 5, 1},
                                                               {4, 5, 1}});
}

TEST_CASE("three triangles on one edge", "[points:1]") {
    hint("Do you count the faces, or only whether there is a second one?");
    const Fixture fan3 = zoo::fan3();
    const OnMesh on(fan3);
    const std::vector<EdgeInfo> found = edges(fan3.mesh);
    CHECK(found.size() == 7);
    CHECK(std::count_if(found.begin(), found.end(),
                        [](EdgeInfo e) { return e.faces == 3; }) == 1);
    CHECK(std::count_if(found.begin(), found.end(),
                        [](EdgeInfo e) { return e.faces == 1; }) == 6);
}
