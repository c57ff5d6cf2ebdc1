#include "exercises/06_geometry/vertex_normal.h"

#include "course/halfedge/build.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

/// The box of the statement, and a half-edge that leaves its corner (1,2,3).
struct Box {
    Fixture fixture;
    int i = 0;
};

Box box() {
    std::vector<Vec3> positions;
    for (int v = 0; v < 8; ++v)
        positions.push_back({1.0 * (v & 1), 1.0 * (v & 2), 0.75 * (v & 4)});
    IndexedMesh mesh{positions,
                     {{7, 5, 1},
                      {7, 1, 3},
                      {7, 3, 6},
                      {6, 3, 2},
                      {7, 6, 4},
                      {7, 4, 5},
                      {0, 4, 6},
                      {0, 6, 2},
                      {0, 2, 3},
                      {0, 3, 1},
                      {0, 1, 5},
                      {0, 5, 4}},
                     {}};
    Box made{{"box", mesh, build(mesh)}};
    while (made.fixture.he[made.i].vi != 7) ++made.i;
    return made;
}

Vec3 at_corner(Weight weight) {
    const Box made = box();
    const OnMesh on(made.fixture);
    return vertex_normal(made.fixture.he, made.fixture.mesh.positions, made.i,
                         weight);
}

}  // namespace

TEST_CASE("the corner of a box, by angle", "[points:1]") {
    hint("Which two sides of a triangle make its angle at the vertex?");
    CHECK_THAT(at_corner(Weight::angle), IsDirection({1, 1, 1}));
}

TEST_CASE("the corner of a box, uniform and by area", "[points:1]") {
    hint("Is it the unit normals that you add up, and each with its weight?");
    CHECK_THAT(at_corner(Weight::uniform), IsDirection({2, 1, 2}));
    CHECK_THAT(at_corner(Weight::area), IsDirection({6, 1.5, 2}));
}

TEST_CASE("on the border, and where normals cancel out", "[points:1]") {
    hint("What does the walk meet where there is no face?");
    for (const Weight weight : {Weight::uniform, Weight::area, Weight::angle}) {
        const Fixture fan = zoo::fan6();
        const OnMesh on(fan);
        for (int i = 0; i < fan.he.size(); ++i)
            CHECK_THAT(vertex_normal(fan.he, fan.mesh.positions, i, weight),
                       IsDirection({0, 0, 1}));
        const Fixture pillow = zoo::pillow();
        const OnMesh on_pillow(pillow);
        CHECK_THAT(vertex_normal(pillow.he, pillow.mesh.positions, 0, weight),
                   IsDirection({}));
    }
}
