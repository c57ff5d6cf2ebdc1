#include "exercises/06_geometry/polygon_normal.h"

#include "course/halfedge/build.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

Fixture bent_quad() {
    IndexedMesh mesh{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2, 3}}, {}};
    HalfEdgeTable he = build(mesh);
    return {"bent quad", mesh, he};
}

}  // namespace

TEST_CASE("the faces of the slide mesh look up", "[points:1]") {
    hint("Which three vertices make a wedge, and which two sides?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    for (const int i : {1, 3, 5, 4, 11, 15, 12, 8, 14, 9})
        CHECK_THAT(polygon_normal(slide.he, slide.mesh.positions, i),
                   IsDirection({0, 0, 1}));
}

TEST_CASE("the bent quad of the statement", "[points:1]") {
    hint("Compare with the table in the statement, line by line.");
    const Fixture quad = bent_quad();
    const OnMesh on(quad);
    for (int i = 0; i < quad.he.size(); ++i)
        if (quad.he[i].fi == 0)
            CHECK_THAT(polygon_normal(quad.he, quad.mesh.positions, i),
                       IsDirection({-1, -1, 2}));
}

TEST_CASE("a border half-edge has no face", "[points:1]") {
    hint("What is asked first, before the walk?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(polygon_normal(slide.he, slide.mesh.positions, 0),
               IsDirection({}));
}
