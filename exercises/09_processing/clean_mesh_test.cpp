#include "exercises/09_processing/clean_mesh.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

std::vector<int> face(const IndexedMesh& mesh, int f) {
    return {mesh.faces[f].begin(), mesh.faces[f].end()};
}

}  // namespace

TEST_CASE("two of four faces stay, and four of five vertices", "[points:1]") {
    hint("What is left of each face? Is it a face, and is it a new one?");
    const Fixture mesh{"rubbish",
                       {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}},
                        {{3, 1, 1, 2}, {2, 2, 1}, {1, 2, 3}, {4, 1, 2}},
                        {}},
                       {}};
    const OnMesh on(mesh);
    const IndexedMesh got = clean_mesh(mesh.mesh);
    CHECK(got.positions == std::vector<Vec3>{{1, 0}, {1, 1}, {0, 1}, {2, 0}});
    REQUIRE(got.faces.size() == 2);
    CHECK_THAT(face(got, 0), IsRotationOf({2, 0, 1}));
    CHECK_THAT(face(got, 1), IsRotationOf({3, 0, 1}));
}

TEST_CASE("a clean mesh stays as it is", "[points:1]") {
    hint("Do you drop anything that the header does not name?");
    for (const Fixture& mesh : {zoo::slide(), zoo::house_with_wall()}) {
        const OnMesh on(mesh);
        const IndexedMesh got = clean_mesh(mesh.mesh);
        CHECK(got.positions == mesh.mesh.positions);
        REQUIRE(got.faces.size() == mesh.mesh.faces.size());
        for (int f = 0; f < got.faces.size(); ++f)
            CHECK_THAT(face(got, f), IsRotationOf(face(mesh.mesh, f)));
    }
}

TEST_CASE("two triangles back to back are two faces", "[points:1]") {
    hint("Do (0,1,2) and (0,2,1) have their corners in the same order?");
    const Fixture pillow = zoo::pillow();
    const OnMesh on(pillow);
    CHECK(clean_mesh(pillow.mesh).faces.size() == 2);
}
