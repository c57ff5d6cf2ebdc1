// Hidden suite of triangulate_convex.
#include "exercises/08_making/triangulate_convex.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

std::vector<int> list(FaceList::Face face) {
    return {face.begin(), face.end()};
}

/// Requires the fan of each face, triangle by triangle.
void check_faces(const IndexedMesh& mesh, const IndexedMesh& cut) {
    int t = 0;
    for (const FaceList::Face face : mesh.faces)
        for (std::size_t k = 2; k < face.size(); ++k, ++t) {
            REQUIRE(t < cut.faces.size());
            const auto got = list(cut.faces[t]);
            const std::vector<int> wanted = {face[0], face[k - 1], face[k]};
            if (IsRotationOf(wanted).match(got)) continue;
            INFO("triangle " << t << ", of the face " << show(list(face)));
            REQUIRE_THAT(got, IsRotationOf(wanted));
        }
    REQUIRE(cut.faces.size() == t);
}

void check(const IndexedMesh& mesh) {
    const IndexedMesh cut = triangulate_convex(mesh);
    check_faces(mesh, cut);
    CHECK((cut.positions == mesh.positions));
    CHECK(cut.loose_edges == mesh.loose_edges);
}

/// A mesh that is not drawn: any numbers may be in its faces.
IndexedMesh of_faces(int vertices, FaceList faces) {
    IndexedMesh mesh;
    for (int v = 0; v < vertices; ++v) {
        const double x = v;
        mesh.positions.push_back({x, x * x, 0});
    }
    mesh.faces = std::move(faces);
    return mesh;
}

}  // namespace

TEST_CASE("triangles and quads", "[points:2]") {
    hint("How is a face wound, and how are the triangles that you make of it?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::tetra(), zoo::cube(), zoo::house(),
          zoo::annulus(), zoo::torus7(), zoo::lens()}) {
        const OnMesh on(fixture);
        const IndexedMesh cut = triangulate_convex(fixture.mesh);
        check_faces(fixture.mesh, cut);
    }
}

TEST_CASE("faces with many corners", "[points:1]") {
    hint("Which corner is in every triangle of a fan?");
    for (const Fixture& fixture :
         {hidden::twelve_gon(), hidden::prism(), hidden::gaps()}) {
        const OnMesh on(fixture);
        check_faces(fixture.mesh, triangulate_convex(fixture.mesh));
    }
    const IndexedMesh fives =
        of_faces(10, {{9, 3, 0, 5, 7}, {2, 4, 6, 8, 1}, {3, 2, 9}});
    check_faces(fives, triangulate_convex(fives));
}

TEST_CASE("positions and loose edges stay", "[points:1]") {
    hint("What does a mesh consist of, beside its faces?");
    for (const Fixture& fixture :
         {zoo::dangling(), hidden::gaps(), hidden::loose_chain(),
          hidden::bridge(), zoo::bow_tie_crossed()}) {
        const OnMesh on(fixture);
        check(fixture.mesh);
    }
}

TEST_CASE("no faces, and meshes that are not manifold", "[points:1]") {
    hint("Do you rely on anything but the corners of one face?");
    check({});
    check(of_faces(3, {}));
    for (const Fixture& fixture :
         {zoo::moebius3q(), zoo::fan3(), zoo::house_with_wall(),
          hidden::keyhole(), hidden::spur()}) {
        const OnMesh on(fixture);
        check(fixture.mesh);
    }
}

TEST_CASE("renumbered and generated meshes", "[points:2]") {
    hint("Which numbers do you use that are not in the face itself?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), generated_fixtures()})
        for (const Fixture& fixture : fixtures) {
            const OnMesh on(fixture);
            check(fixture.mesh);
        }
}

TEST_CASE("faces with fewer than three corners are refused", "[points:1]") {
    hint("Is every face looked at, the first and the last, before it is cut?");
    for (const FaceList& faces :
         {FaceList{{}}, FaceList{{0}}, FaceList{{0, 1}},
          FaceList{{0, 1}, {0, 1, 2}}, FaceList{{0, 1, 2}, {3}},
          FaceList{{0, 1, 2, 3}, {}, {0, 1, 2}},
          FaceList{{0, 1, 2, 3}, {3, 2}, {0, 1, 2}}})
        CHECK_THROWS_AS(triangulate_convex(of_faces(4, faces)),
                        std::invalid_argument);
}

TEST_CASE("the cost grows no faster than the mesh", "[points:1][once]") {
    hint("What do you copy, or look through, once for each face?");
    check(grid(180, 180));
    FaceList one;
    std::vector<int> corners(40000);
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = static_cast<int>(k);
    one.push_back(corners);
    check(of_faces(40000, one));
}
