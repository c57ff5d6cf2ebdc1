#include "exercises/05_structures/weld.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("two triangles with a common edge have four vertices", "[points:1]") {
    hint("Which of the six corners lie where there is a vertex already?");
    const Soup soup = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                       {{{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}}};
    const IndexedMesh mesh = weld(soup, 0);
    CHECK(mesh.positions ==
          std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
    CHECK(mesh.faces == FaceList{{0, 1, 2}, {2, 1, 3}});
}

TEST_CASE("corners on a line, some of them in reach of a vertex",
          "[points:1]") {
    hint("Do you compare a corner with vertices, or with other corners?");
    const Soup soup = {{{{0, 0, 0}, {0.8, 0, 0}, {1.6, 0, 0}}},
                       {{{2.4, 0, 0}, {3.2, 0, 0}, {0, 0, 9}}}};
    const IndexedMesh mesh = weld(soup, 1);
    CHECK(mesh.positions ==
          std::vector<Vec3>{{0, 0, 0}, {1.6, 0, 0}, {3.2, 0, 0}, {0, 0, 9}});
    CHECK(mesh.faces == FaceList{{0, 0, 1}, {1, 2, 3}});
}

TEST_CASE("a negative distance is refused", "[points:1]") {
    hint("What is to happen when eps is below 0?");
    const Soup soup = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    CHECK_THROWS_AS(weld(soup, -1), std::invalid_argument);
}
