// Hidden suite of cluster. Expected meshes come from comparing all vertices
// with each other, or are written out.
#include "exercises/09_processing/cluster.h"

#include <limits>

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/clustering_oracle.h"
#include "grader/suites/09_processing/face_lists.h"
#include "grader/suites/09_processing/smoothing_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

double size_of(const std::vector<Vec3>& positions) {
    double size = 1e-3;
    for (const Vec3 p : positions) size = std::max(size, length(p));
    return size;
}

void check_is(const IndexedMesh& got, const IndexedMesh& expected) {
    CHECK(hidden::faces_from_smallest(got.faces) ==
          hidden::faces_from_smallest(expected.faces));
    CHECK_THAT(got.positions,
               AreAt(expected.positions, size_of(expected.positions)));
    CHECK(got.loose_edges.empty());
}

void check_cluster(const Fixture& fixture, double cell) {
    const OnMesh on(fixture);
    INFO("cell " << cell);
    check_is(cluster(fixture.mesh, cell),
             oracle::clustered_mesh(fixture.mesh, cell));
}

Fixture unnumbered(const std::string& name, IndexedMesh mesh) {
    return {name, std::move(mesh), {}};
}

/// The same mesh, moved.
Fixture moved(Fixture fixture, Vec3 by) {
    for (Vec3& p : fixture.mesh.positions) p = p + by;
    return fixture;
}

/// Vertices k at (x[k], 0.25, 0.25), for faces that cell 1 joins as x says.
Fixture in_a_row(const std::string& name, const std::vector<double>& x,
                 FaceList faces) {
    IndexedMesh mesh{{}, std::move(faces), {}};
    for (const double px : x) mesh.positions.push_back({px, 0.25, 0.25});
    return unnumbered(name, std::move(mesh));
}

}  // namespace

TEST_CASE("triangles that fall together in twos and threes", "[points:2]") {
    hint("After corners fall together, which triangles have three left?");
    const Fixture plane = moved(
        unnumbered("plane", grid(9, 7, Cells::triangles)), {0.5, 0.5, 0.5});
    for (const double cell : {1.0, 2.0, 3.0, 4.0}) check_cluster(plane, cell);
    const Fixture ball = moved(unnumbered("ball", icosphere(2)), {2, 2, 2});
    for (const double cell : {0.3, 0.55, 0.8}) check_cluster(ball, cell);
}

TEST_CASE("meshes round the origin", "[points:2]") {
    hint("What is -0.5 / 1, rounded down? And rounded towards 0?");
    for (const double cell : {0.35, 0.7, 1.7}) {
        check_cluster(unnumbered("ball", icosphere(2)), cell);
        check_cluster(unnumbered("torus", torus(12, 8)), cell);
        check_cluster(moved(unnumbered("torus", torus(12, 8, Cells::triangles)),
                            {-5.1, -0.3, 0.4}),
                      cell);
    }
    const Fixture pair = unnumbered(
        "two triangles across the origin",
        {{{-0.5, 0.1, 0.1}, {0.5, 0.1, 0.1}, {0.1, 3.5, 0.1}, {0.1, -3.5, 0.1}},
         {{0, 1, 2}, {1, 0, 3}},
         {}});
    const OnMesh on(pair);
    check_is(cluster(pair.mesh, 1), pair.mesh);
}

TEST_CASE("corners of a polygon that follow each other become one",
          "[points:2]") {
    hint("Which corners follow each other, after the last one, too?");
    const std::vector<double> x = {0.2, 0.4, 1.2, 1.4, 2.2, 2.4, 3.2, 0.6};
    const Fixture faces = in_a_row("polygons", x,
                                   {{0, 1, 2, 4},
                                    {0, 2, 3, 4},
                                    {0, 2, 4, 5},
                                    {0, 2, 4, 1},
                                    {1, 0, 2, 3, 4, 5},
                                    {0, 2, 3, 4, 5, 1},
                                    {0, 2, 4, 6, 7, 1},
                                    {7, 1, 0, 2, 3, 6},
                                    {6, 4, 3, 2, 0},
                                    {1, 4, 6, 2}});
    const OnMesh on(faces);
    const IndexedMesh got = cluster(faces.mesh, 1);
    const FaceList expected{{0, 1, 2},    {0, 1, 2},   {0, 1, 2},    {0, 1, 2},
                            {0, 1, 2},    {0, 1, 2},   {0, 1, 2, 3}, {0, 1, 3},
                            {3, 2, 1, 0}, {0, 2, 3, 1}};
    CHECK(hidden::faces_from_smallest(got.faces) ==
          hidden::faces_from_smallest(expected));
    check_cluster(faces, 1);
}

TEST_CASE("a face that still comes to a vertex twice is dropped",
          "[points:1]") {
    hint("Can two corners be the same although they do not follow each other?");
    const std::vector<double> x = {0.2, 0.4, 1.2, 1.4, 2.2, 3.2};
    const Fixture faces = in_a_row("polygons", x,
                                   {{0, 2, 1, 4},
                                    {2, 0, 4, 1},
                                    {0, 2, 4, 3, 5},
                                    {0, 2, 4, 5},
                                    {2, 0, 3, 1},
                                    {0, 1, 2, 1, 0, 4},
                                    {4, 2, 0}});
    const OnMesh on(faces);
    const IndexedMesh got = cluster(faces.mesh, 1);
    const FaceList expected{{0, 1, 2, 3}, {2, 1, 0}};
    CHECK(hidden::faces_from_smallest(got.faces) ==
          hidden::faces_from_smallest(expected));
    check_cluster(faces, 1);
}

TEST_CASE("the mean of all vertices in the cube", "[points:1]") {
    hint("Which vertices take part in the mean? Each of them once?");
    Fixture mesh = unnumbered("two vertices no face uses", zoo::slide().mesh);
    mesh.mesh.positions.push_back({0.5, 0.25, 1.5});
    mesh.mesh.positions.push_back({1.5, -0.5, 1.5});
    const OnMesh on(mesh);
    const IndexedMesh got = cluster(mesh.mesh, 2);
    CHECK_THAT(
        got.positions,
        AreAt({{0.5, 1.25 / 3, 0.5}, {4.0 / 3, -3.5 / 3, 0.5}, {2, 1}, {2, -1}},
              3));
    for (const double cell : {1.9, 3.3, 5.0}) {
        check_cluster(mesh, cell);
        check_cluster(unnumbered("prism", hidden::prism().mesh), cell);
    }
}

TEST_CASE("vertices in the order of their cubes, no unused ones",
          "[points:2]") {
    hint("Which vertices are left without a face, and who moves up?");
    const Fixture mesh =
        unnumbered("scattered", {{{7.5, 0, 0},
                                  {9.5, 0, 0},
                                  {0.5, 0, 0},
                                  {3.25, 0, 0},
                                  {0.75, 0, 0},
                                  {5.5, 5, 0},
                                  {3.75, 0, 0},
                                  {7.25, 0, 0}},
                                 {{2, 4, 5}, {5, 3, 7}, {6, 4, 5}},
                                 {}});
    const OnMesh on(mesh);
    const IndexedMesh got = cluster(mesh.mesh, 1);
    check_is(got, {{{7.375, 0, 0}, {0.625, 0, 0}, {3.5, 0, 0}, {5.5, 5, 0}},
                   {{3, 2, 0}, {2, 1, 3}},
                   {}});
    check_cluster(mesh, 4);
    check_cluster(mesh, 2);
}

TEST_CASE("very large and very small cubes", "[points:1]") {
    hint("How large can x / cell get? Does it fit into what you keep it in?");
    Fixture mesh = unnumbered("house", zoo::house().mesh);
    mesh.mesh = hidden::roughened(mesh.mesh, 30);
    for (Vec3& p : mesh.mesh.positions) p = 1000 * p;
    for (const double cell : {1e-3, 1e-6, 1e-9, 1e-11}) {
        const OnMesh on(mesh);
        check_is(cluster(mesh.mesh, cell), mesh.mesh);
    }
    for (const double cell : {1e7, 1e12, 1e300}) {
        check_cluster(mesh, cell);
        check_cluster(moved(mesh, {5000, 5000, 5000}), cell);
    }
}

TEST_CASE("cubes far from each other whose numbers look alike", "[points:1]") {
    hint("Can two cubes get the same key? Try (1, 23, 4) and (12, 3, 4).");
    for (const double many : {10.0, 100.0, 256.0, 1000.0, 1024.0, 10000.0,
                              65536.0, 1e6, 1048576.0}) {
        const Fixture far =
            unnumbered("far from each other", {{{many + 0.5, 0.5, 0.5},
                                                {0.5, 1.5, 0.5},
                                                {0.5, many + 0.5, 0.5},
                                                {0.5, 0.5, 1.5},
                                                {many * many + 0.5, 0.5, 0.5}},
                                               {{0, 1, 2, 3, 4}, {3, 2, 1}},
                                               {}});
        const OnMesh on(far);
        check_is(cluster(far.mesh, 1), far.mesh);
    }
    const Fixture digits =
        unnumbered("numbers of several digits", {{{1.5, 23.5, 4.5},
                                                  {12.5, 3.5, 4.5},
                                                  {1.5, 2.5, 34.5},
                                                  {4.5, 3.5, 12.5}},
                                                 {{0, 1, 2, 3}},
                                                 {}});
    check_cluster(digits, 1);
}

TEST_CASE("vertices on the sides of the cubes", "[points:1]") {
    hint("To which cube belongs a vertex that lies exactly between two?");
    for (const double cell : {0.5, 1.0, 2.0, 4.0, 8.0}) {
        check_cluster(unnumbered("plane", grid(8, 8)), cell);
        check_cluster(moved(unnumbered("plane", grid(8, 5, Cells::triangles)),
                            {-4, -3, -2}),
                      cell);
    }
    Fixture zero = unnumbered(
        "0 and -0", {{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {-0.0, 0, -0.0}},
                     {{0, 1, 2}, {3, 1, 2}},
                     {}});
    check_cluster(zero, 1);
}

TEST_CASE("any mesh goes in, and what comes out stays", "[points:2]") {
    hint("Do you drop, or refuse, anything that the header does not name?");
    for (const Fixture& mesh : hidden::zoo_without_table())
        for (const double cell : {0.3, 1.3, 2.2, 3.1})
            check_cluster(mesh, cell);
    IndexedMesh plate = grid(4, 4, Cells::triangles);  // and its lower side
    const int shift = plate.vertex_count();
    const FaceList upper = plate.faces;
    for (int v = 0; v < shift; ++v)
        plate.positions.push_back(plate.positions[static_cast<std::size_t>(v)] +
                                  Vec3{0.25, 0.25, 0.5});
    for (const FaceList::Face face : upper)
        plate.faces.push_back(
            {face[0] + shift, face[2] + shift, face[1] + shift});
    for (const double cell : {1.0, 2.0})
        check_cluster(unnumbered("thin plate", plate), cell);
    const Fixture twice =
        unnumbered("faces that are there twice",
                   {{{0.5, 0, 0}, {1.5, 0, 0}, {1.5, 1.5, 0}, {0.25, 0, 0}},
                    {{0, 1, 2}, {1, 2, 3}, {2, 1, 0}, {0, 1, 2}},
                    {}});
    check_cluster(twice, 1);
}

TEST_CASE("every mesh, under every numbering", "[points:2]") {
    hint("Which numbers do you take to mean something that they do not?");
    std::vector<Fixture> meshes = hidden::made_by_hand();
    for (const Fixture& mesh : hidden::renumbered_copies())
        meshes.push_back(mesh);
    for (const Fixture& mesh : generated_fixtures()) meshes.push_back(mesh);
    for (Fixture& mesh : meshes) {
        mesh.mesh = hidden::roughened(mesh.mesh, 31);
        for (const double cell : {0.9, 2.3}) check_cluster(mesh, cell);
    }
}

TEST_CASE("a mesh and its cubes, larger and smaller", "[points:1]") {
    hint("Does the result depend on how large the numbers are?");
    const Fixture plain = unnumbered("house", zoo::house().mesh);
    for (const double scale : {1.0 / 1024, 1.0, 16384.0}) {
        Fixture mesh = plain;
        mesh.mesh = hidden::roughened(mesh.mesh, 32);
        for (Vec3& p : mesh.mesh.positions) p = scale * p;
        for (const double cell : {0.45, 0.8, 1.1})
            check_cluster(mesh, scale * cell);
    }
}

TEST_CASE("a cube without a size is refused", "[points:1]") {
    hint("Is NaN above 0? Is it not above 0?");
    const Fixture mesh = zoo::cube();
    const OnMesh on(mesh);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double cell : {0.0, -0.0, -1.0, -1e-300, infinity, -infinity,
                              std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_THROWS_AS(cluster(mesh.mesh, cell), std::invalid_argument);
        CHECK_THROWS_AS(cluster({}, cell), std::invalid_argument);
    }
}

TEST_CASE("no mesh, no face, faces of two corners", "[points:1]") {
    hint("Does your loop over a face also work when it has few corners?");
    check_is(cluster({}, 1), {});
    check_cluster(unnumbered("points only", {{{1, 2, 3}, {1, 2, 3}}, {}, {}}),
                  1);
    check_cluster(
        unnumbered("short faces", {{{1, 2, 3}, {4, 5, 6}, {7, 8, 8}},
                                   {{0, 1}, {2}, {0, 1, 2}, {1, 1, 2}, {}},
                                   {}}),
        1);
    const Fixture loose = zoo::dangling();
    check_cluster(loose, 0.5);
    check_cluster(loose, 2);
}

TEST_CASE("a large mesh takes no longer than sorting it", "[points:1][once]") {
    hint("For one vertex, how many others do you compare it with?");
    Fixture many = unnumbered("many triangles", {});
    for (int v = 0; v < 12000; ++v) {
        many.mesh.positions.push_back(
            {static_cast<double>(v * 7 % 12000), static_cast<double>(v % 11)});
        if (v % 3 == 2) many.mesh.faces.push_back({v - 2, v - 1, v});
    }
    const IndexedMesh got = cluster(many.mesh, 0.75);
    CHECK_THAT(got.positions, AreAt(many.mesh.positions, 12000));
    CHECK(got.faces.size() == many.mesh.faces.size());
}
