// Hidden suite of polygon_normal: normals that are known without a computation,
// and sums over the corners that the face list gives.
#include "exercises/06_geometry/polygon_normal.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/by_faces.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Some of the half-edges: each call costs its time.
std::vector<int> asked(const HalfEdgeTable& he) {
    constexpr int most = 24;
    const int step = std::max(1, he.size() / most);
    std::vector<int> some;
    for (int i = 0; i < he.size(); i += step) some.push_back(i);
    return some;
}

Vec3 expected_of(const IndexedMesh& mesh, int face) {
    if (face == -1) return {};
    const std::vector<Vec3> corners = normals::corners_of(mesh, face);
    const Vec3 sum = normals::sum_over_corners(corners);
    const double size = normals::squared_sides(corners);
    return length(sum) <= 1e-12 * size ? Vec3{} : sum;
}

void check_mesh(const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::ByFaces faces(fixture);
    for (const int i : asked(fixture.he))
        CHECK_THAT(polygon_normal(fixture.he, fixture.mesh.positions, i),
                   IsDirection(expected_of(fixture.mesh, faces.face(i))));
}

/// One face with these corners, and its border.
Fixture polygon(std::string name, std::vector<Vec3> corners) {
    IndexedMesh mesh;
    std::vector<int> face;
    for (std::size_t k = 0; k < corners.size(); ++k)
        face.push_back(static_cast<int>(k));
    mesh.positions = std::move(corners);
    mesh.faces.push_back(face);
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

/// The face has this normal from each of its half-edges, or from every
/// `step`-th; the border has none.
void check_polygon(const Fixture& fixture, Vec3 normal, int step = 1) {
    const OnMesh on(fixture);
    for (int i = 0; i < fixture.he.size(); i += step) {
        const bool has_face = fixture.he.rows()[at(i)].fi == 0;
        CHECK_THAT(polygon_normal(fixture.he, fixture.mesh.positions, i),
                   IsDirection(has_face ? normal : Vec3{}));
    }
}

void check_polygon_in_all_motions(const Fixture& fixture, Vec3 normal) {
    check_polygon(renumbered(fixture, 1), normal);
    for (const normals::Motion& motion : normals::motions())
        check_polygon(normals::moved(fixture, motion), motion.direction(normal),
                      3);
}

std::vector<Vec3> regular(int n) {
    std::vector<Vec3> corners;
    for (int k = 0; k < n; ++k)
        corners.push_back({std::cos(6.283185307179586 * k / n),
                           std::sin(6.283185307179586 * k / n), 0});
    return corners;
}

//      5---4       a notch, seen from above:
//      |   |           5-------4 ,2-----1
//      |   3---2       |         3      |
//      |       |       |                |
//      0-------1       6----------------0
std::vector<Fixture> not_convex() {
    return {
        polygon("L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}),
        polygon("notch",
                {{4, 0}, {4, 2}, {2.5, 2}, {2, 1}, {1.5, 2}, {0, 2}, {0, 0}}),
        polygon("arrow", {{0, 0}, {4, 3}, {0, 6}, {1, 3}})};
}

}  // namespace

TEST_CASE("the sides of boxes", "[points:1]") {
    hint("Does the normal of each face of a closed mesh point outwards?");
    for (const Fixture& fixture : {zoo::cube(), renumbered(zoo::cube(), 2),
                                   renumbered(zoo::cube(), 3)}) {
        const OnMesh on(fixture);
        const oracle::ByFaces faces(fixture);
        for (int i = 0; i < fixture.he.size(); ++i) {
            // From the middle of the cube to the middle of the face.
            Vec3 outwards{-0.5, -0.5, -0.5};
            for (const Vec3 p :
                 normals::corners_of(fixture.mesh, faces.face(i)))
                outwards = outwards + 0.25 * p;
            CHECK_THAT(polygon_normal(fixture.he, fixture.mesh.positions, i),
                       IsDirection(outwards));
        }
    }
}

TEST_CASE("planar polygons of three to twelve sides", "[points:1]") {
    hint("Is every corner counted, and each of them once?");
    for (const int n : {3, 4, 5, 6, 7, 12})
        check_polygon_in_all_motions(polygon("regular polygon", regular(n)),
                                     {0, 0, 1});
    for (const Fixture& fixture : not_convex())
        check_polygon_in_all_motions(fixture, {0, 0, 1});
}

TEST_CASE("bent quads", "[points:1]") {
    hint(
        "Two wedges of a bent quad do not agree. Are all four in the sum, as "
        "they are?");
    check_polygon_in_all_motions(
        polygon("bent quad", {{0, 0, 0}, {3, 0, 0}, {2, 2, 1}, {0, 1, 0}}),
        cross(Vec3{2, 2, 1}, Vec3{-3, 1, 0}));
    for (std::uint64_t k = 0; k < 20; ++k) {
        const std::vector<Vec3> p = normals::random_points(4, 10 + k);
        check_polygon(polygon("random quad", p),
                      cross(p[2] - p[0], p[3] - p[1]));
    }
}

TEST_CASE("bent polygons with more sides", "[points:1]") {
    hint(
        "The contract asks for the sum of the wedges, not for another normal "
        "of the polygon.");
    for (std::uint64_t k = 0; k < 15; ++k) {
        const auto points =
            normals::random_points(5 + static_cast<int>(k % 5), 40 + k);
        check_polygon_in_all_motions(polygon("random polygon", points),
                                     normals::sum_over_corners(points));
    }
}

TEST_CASE("corners that say nothing", "[points:1]") {
    hint(
        "What is the cross product at a corner in the middle of a straight "
        "side? And its unit vector?");
    check_polygon_in_all_motions(
        polygon("square with corners on its sides",
                {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0.5, 2}, {0, 2}}),
        {0, 0, 1});
    check_polygon_in_all_motions(
        polygon("square with two corners at one place",
                {{0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}),
        {0, 0, 1});
    check_polygon_in_all_motions(
        polygon("triangle with three corners at one place",
                {{2, 0}, {0, 2}, {0, 0}, {0, 0}, {0, 0}}),
        {0, 0, 1});
}

TEST_CASE("faces that have no normal", "[points:1]") {
    hint(
        "When is the sum so short that its direction means nothing? What do "
        "you compare it with?");
    const Vec3 along{0.3, 0.7, 1.1};
    check_polygon_in_all_motions(
        polygon("triangle on a line", {Vec3{}, 0.3 * along, 1.7 * along}), {});
    check_polygon_in_all_motions(
        polygon("polygon on a line",
                {0.1 * along, 0.7 * along, 1.3 * along, 0.9 * along}),
        {});
    check_polygon_in_all_motions(
        polygon("all corners at one place", {along, along, along, along}), {});
    check_polygon_in_all_motions(
        polygon("quad that crosses itself",
                {{0.1, 0.2}, {1.3, 1.4}, {1.3, 0.2}, {0.1, 1.4}}),
        {});
}

TEST_CASE("very small, very thin, and far away", "[points:1]") {
    hint("Small compared with what? And which digits does a distance cost?");
    // The sum over a strip is 4 w, the squares of its sides are 2 in all.
    for (const double s : {1e-30, 1e-9, 1e-5, 1e5, 1e9, 1e30})
        check_polygon(
            polygon("square", {{0, 0, 0}, {0, s, 0}, {0, s, s}, {0, 0, s}}),
            {1, 0, 0});
    for (const double w : {1e-12, 1e-10, 1e-6})
        check_polygon(polygon("strip", {{0, 0}, {1, 0}, {1, w}, {0, w}}),
                      {0, 0, 1});
    for (const double w : {0.3e-12, 1e-14})
        check_polygon(polygon("no strip", {{0, 0}, {1, 0}, {1, w}, {0, w}}),
                      {});
    for (std::uint64_t k = 0; k < 20; ++k) {
        const auto points = normals::random_points(5, 80 + k);
        check_polygon(normals::moved(polygon("random polygon", points),
                                     normals::far_away()),
                      normals::sum_over_corners(points));
    }
}

TEST_CASE("every face of every mesh, at random points", "[points:1]") {
    hint("Which half-edge has no face, and which vertices has each other?");
    std::uint64_t salt = 200;
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_mesh(normals::at_random_points(fixture, ++salt));
    for (const Fixture& fixture : generated_fixtures())
        check_mesh(normals::at_random_points(fixture, ++salt));
}

TEST_CASE("no more reads than the sides of the face need", "[points:1]") {
    hint("Do you look at half-edges that are not on the face?");
    for (const Fixture& fixture :
         {renumbered(Fixture{"grid", grid(30, 30), build(grid(30, 30))}),
          renumbered(polygon("polygon of 100 sides", regular(100)))}) {
        const OnMesh on(fixture);
        const int sides = fixture.mesh.faces.size() == 1 ? 100 : 4;
        for (const int i : asked(fixture.he)) {
            if (fixture.he.rows()[at(i)].fi == -1) continue;
            const ReadBudget budget(fixture.he, 20 * sides + 20);
            CHECK_THAT(polygon_normal(fixture.he, fixture.mesh.positions, i),
                       IsDirection({0, 0, 1}));
        }
    }
}
