// Hidden suite of clean_mesh. Expected meshes are written out, or found by
// comparing each face with every other one.
#include "exercises/09_processing/clean_mesh.h"

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/defect_oracle.h"
#include "grader/suites/09_processing/face_lists.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Corners = std::vector<int>;

Fixture of_faces(const std::string& name, int vertices, FaceList faces) {
    IndexedMesh mesh{{}, std::move(faces), {}};
    for (int v = 0; v < vertices; ++v)
        mesh.positions.push_back({v % 5 * 1.0, v / 5 * 1.0, v * v % 7 * 0.5});
    return {name, std::move(mesh), {}};
}

/// Step 1, one corner at a time.
Corners merged(Corners face) {
    for (std::size_t k = 0; k < face.size() && face.size() > 1;)
        if (face[k] == face[(k + 1) % face.size()])
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(k)), k = 0;
        else
            ++k;
    return face;
}

bool is_degenerate(const Corners& face) {
    for (const int v : face)
        if (std::count(face.begin(), face.end(), v) > 1) return true;
    return face.size() < 3;
}

bool is_rotation(const Corners& a, Corners b) {
    for (std::size_t k = 0; k < b.size(); ++k) {
        if (a == b) return true;
        std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    return false;
}

/// The definition, taken literally. Quadratic.
IndexedMesh cleaned(const IndexedMesh& mesh) {
    std::vector<Corners> faces;
    for (const FaceList::Face span : mesh.faces) {
        const Corners face = merged({span.begin(), span.end()});
        const auto same = [&](const Corners& other) {
            return is_rotation(face, other);
        };
        if (!is_degenerate(face) &&
            std::none_of(faces.begin(), faces.end(), same))
            faces.push_back(face);
    }
    IndexedMesh result;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const auto uses = [&](const Corners& face) {
            return std::count(face.begin(), face.end(), v) > 0;
        };
        if (std::none_of(faces.begin(), faces.end(), uses)) continue;
        const int now = result.vertex_count();
        for (Corners& face : faces)  // now <= v: no later vertex is hit
            std::replace(face.begin(), face.end(), v, now);
        result.positions.push_back(mesh.positions[static_cast<std::size_t>(v)]);
    }
    for (const Corners& face : faces) result.faces.push_back(face);
    return result;
}

void check_is(const IndexedMesh& got, const IndexedMesh& expected) {
    CHECK(hidden::faces_from_smallest(got.faces) ==
          hidden::faces_from_smallest(expected.faces));
    CHECK(got.positions == expected.positions);
    CHECK(got.loose_edges.empty());
}

void check_clean(const Fixture& fixture) {
    const OnMesh on(fixture);
    check_is(clean_mesh(fixture.mesh), cleaned(fixture.mesh));
}

/// For faces on vertices that all stay in use.
void check_faces(const Fixture& fixture, const FaceList& expected) {
    const OnMesh on(fixture);
    CHECK(hidden::faces_from_smallest(clean_mesh(fixture.mesh).faces) ==
          hidden::faces_from_smallest(expected));
    check_clean(fixture);
}

}  // namespace

TEST_CASE("corners that follow themselves become one", "[points:2]") {
    hint("How many corners are left when a vertex comes twice in a row?");
    check_faces(
        of_faces("twice in a row", 6,
                 {{0, 1, 1, 2},
                  {2, 2, 3, 4},
                  {3, 4, 5, 5},
                  {0, 0, 0, 3, 5},
                  {1, 3, 3, 3, 5, 5},
                  {4, 4, 1, 1, 0, 0}}),
        {{0, 1, 2}, {2, 3, 4}, {3, 4, 5}, {0, 3, 5}, {1, 3, 5}, {4, 1, 0}});
    check_faces(of_faces("round the end", 5,
                         {{0, 1, 2, 0},
                          {1, 1, 2, 3, 1},
                          {2, 3, 4, 2, 2},
                          {4, 4, 0, 1, 4, 4},
                          {0, 0, 2, 4, 1, 0, 0, 0}}),
                {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {4, 0, 1}, {0, 2, 4, 1}});
}

TEST_CASE("degenerate faces are dropped", "[points:2]") {
    hint("Can a vertex come twice, without following itself?");
    check_faces(of_faces("degenerate", 4,
                         {{0, 1},
                          {2},
                          {},
                          {0, 0, 0},
                          {0, 1, 2},
                          {1, 1, 0},
                          {3, 2, 3},
                          {0, 2, 3},
                          {1, 0, 0, 1, 1},
                          {2, 2}}),
                {{0, 1, 2}, {0, 2, 3}});
    check_faces(of_faces("there and back", 5,
                         {{0, 1, 2, 1},
                          {0, 1, 0, 2},
                          {0, 1, 2, 3, 1},
                          {0, 1, 2, 3, 4},
                          {2, 0, 1, 2, 3, 4},
                          {0, 1, 1, 2, 1, 3},
                          {4, 3, 2, 4, 2}}),
                {{0, 1, 2, 3, 4}});
}

TEST_CASE("of equal faces the first stays", "[points:2]") {
    hint("Which faces are the same, and in what order do the others stay?");
    check_faces(of_faces("again", 5,
                         {{2, 3, 1},
                          {0, 4, 2},
                          {1, 2, 3},
                          {3, 1, 2},
                          {1, 3, 2},
                          {4, 2, 0},
                          {3, 2, 1},
                          {0, 2, 4},
                          {0, 1, 2}}),
                {{2, 3, 1}, {0, 4, 2}, {1, 3, 2}, {0, 2, 4}, {0, 1, 2}});
    check_faces(of_faces("quads with the same corners", 4,
                         {{0, 1, 2, 3},
                          {2, 3, 0, 1},
                          {0, 2, 1, 3},
                          {0, 3, 2, 1},
                          {1, 0, 3, 2},
                          {3, 0, 2, 1}}),
                {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 2, 1}});
    check_faces(of_faces("a part of a face", 5,
                         {{0, 1, 2, 3, 4}, {0, 1, 2}, {0, 1, 2, 3}, {1, 2, 0}}),
                {{0, 1, 2, 3, 4}, {0, 1, 2}, {0, 1, 2, 3}});
}

TEST_CASE("faces that become equal in the first step", "[points:2]") {
    hint("Which step must come before which?");
    check_faces(of_faces("equal by then", 4,
                         {{0, 1, 1, 2},
                          {1, 2, 0},
                          {2, 0, 0, 1, 2},
                          {3, 2, 1},
                          {2, 1, 3, 3},
                          {1, 3, 2, 2, 1}}),
                {{0, 1, 2}, {3, 2, 1}});
    check_faces(of_faces("degenerate ones are no model", 4,
                         {{0, 1, 2, 1},
                          {0, 1, 2},
                          {0, 1, 0},
                          {0, 1, 3},
                          {0, 0, 1, 3},
                          {0, 1, 2, 2, 1}}),
                {{0, 1, 2}, {0, 1, 3}});
}

TEST_CASE("vertices that no face uses", "[points:2]") {
    hint("Who used a vertex before, and who uses it in the end?");
    check_clean(of_faces("gaps", 12, {{9, 2, 4}, {4, 2, 7}, {7, 11, 4}}));
    check_clean(of_faces(
        "used by dropped faces", 9,
        {{0, 1}, {8, 2, 2}, {3, 5, 7}, {6, 5, 6}, {7, 3, 5, 5}, {1, 4, 1, 0}}));
    check_clean(of_faces("the last one only", 5, {{0, 1, 2}, {2, 1, 3}}));
    Fixture same = of_faces("at one position", 6, {{5, 3, 4}, {1, 4, 3}});
    for (Vec3& p : same.mesh.positions) p = {1, 2, 3};
    check_clean(same);
    Fixture exact = of_faces("small and large numbers", 5, {{4, 1, 2}});
    exact.mesh.positions = {{1, 1, 1},
                            {1e-300, -0.0, 1e300},
                            {0.1, 0.2, 0.3},
                            {1, 2, 3},
                            {-1e17, 1 / 3.0, 5}};
    check_clean(exact);
}

TEST_CASE("what is no rubbish stays", "[points:2]") {
    hint("Do you mend anything that the header does not name?");
    for (const Fixture& mesh : hidden::zoo_without_table()) {
        check_clean(mesh);
        const OnMesh on(mesh);
        check_is(clean_mesh(mesh.mesh), mesh.mesh);
    }
    for (const Fixture& mesh : hidden::made_by_hand()) check_clean(mesh);
    for (const Fixture& mesh : hidden::renumbered_copies()) check_clean(mesh);
    on_generated_meshes(generated_fixtures(), check_clean);
}

TEST_CASE("scans with all kinds of rubbish", "[points:3]") {
    hint("Take the four steps in the order of the header, one by one.");
    for (std::uint64_t k = 0; k < 24; ++k) check_clean(hidden::dirty_scan(k));
}

TEST_CASE("a second time there is nothing to do", "[points:1]") {
    hint("Which of your steps makes work for one that came before it?");
    for (std::uint64_t k = 30; k < 38; ++k) {
        const Fixture scan = hidden::dirty_scan(k);
        const OnMesh on(scan);
        const IndexedMesh once = clean_mesh(scan.mesh);
        check_is(once, cleaned(scan.mesh));
        for (const int v : once.faces.corners())
            REQUIRE((0 <= v && v < once.vertex_count()));
        check_is(clean_mesh(once), once);
    }
}

TEST_CASE("nothing, points only, loose edges", "[points:1]") {
    hint("What is left of a mesh without a face?");
    check_is(clean_mesh({}), {});
    check_clean(of_faces("points", 3, {}));
    check_clean(of_faces("rubbish only", 3, {{0, 1}, {2, 2, 2}, {0, 1, 0}}));
    check_clean(zoo::dangling());
    check_clean(hidden::bridge());
}

TEST_CASE("a large mesh takes no longer than sorting it", "[points:1][once]") {
    hint("For one face, how many others do you compare it with?");
    constexpr int triangles = 5000;
    Fixture many = of_faces("many triangles", 3 * triangles, {});
    for (int f = 0; f < triangles; ++f)
        many.mesh.faces.push_back({f, f + triangles, f + 2 * triangles});
    const OnMesh on(many);
    check_is(clean_mesh(many.mesh), many.mesh);
}
