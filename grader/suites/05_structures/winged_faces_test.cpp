// Hidden suite of winged_faces. The structures are made with random numbers and
// directions; what is expected comes from the face list.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

#include "course/runner/by_faces.h"
#include "course/runner/suite.h"
#include "grader/suites/05_structures/winged_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

namespace {

/// The faces that the walk round the start of half-edge i meets, each once.
std::vector<int> faces_met(const ByFaces& expected, int i) {
    std::vector<int> faces = expected.faces_met(i);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::erase(faces, -1);
    return faces;
}

/// Asks for the vertex of each half-edge i, with the edge of i as the one that
/// stands for the vertex, where where(expected, i) holds.
template <class Where>
void check(const std::vector<Fixture>& fixtures, std::uint64_t salt,
           Where where) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const ByFaces expected(fixture);
        hidden::WingedFixture made = hidden::winged_fixture(fixture, salt++);
        for (int i = 0; i < fixture.he.size(); ++i) {
            if (!where(expected, i)) continue;
            const int v = expected.start(i);
            const DirectedEdge side =
                made.directed[static_cast<std::size_t>(i)];
            made.mesh.vertex[static_cast<std::size_t>(v)] = side.edge;
            REQUIRE_THAT(winged_faces(made.mesh, v),
                         IsPermutationOf(faces_met(expected, i)));
        }
    }
}

bool everywhere(const ByFaces&, int) {
    return true;
}

/// All edges stored the same way at each vertex: as leaving the smaller one.
WingedMesh all_forward(const WingedMesh& mesh) {
    WingedMesh turned = mesh;
    for (WingedEdge& e : turned.edges)
        if (e.from > e.to)
            e = {e.to,       e.from,    e.right,      e.left,
                 e.to_right, e.to_left, e.from_right, e.from_left};
    return turned;
}

}  // namespace

TEST_CASE("vertices with faces all round", "[points:2]") {
    hint("Which way is the next edge stored: from v, or to v?");
    for (const std::uint64_t salt : {100U, 200U, 300U})
        check(hidden::made_by_hand(), salt, [](const ByFaces& expected, int i) {
            return expected.place_of_vertex(i) == Place::interior;
        });
}

TEST_CASE("vertices on the border", "[points:2]") {
    hint("Where does the walk go on when there is no face on one side?");
    for (const std::uint64_t salt : {400U, 500U, 600U})
        check(hidden::made_by_hand(), salt, [](const ByFaces& expected, int i) {
            return expected.place_of_vertex(i) == Place::border;
        });
}

TEST_CASE("bow-ties, loose edges, and faces that are met twice", "[points:1]") {
    hint("When is the walk over, and what does it meet until then?");
    for (const std::uint64_t salt : {700U, 800U})
        check(hidden::made_by_hand(), salt, [](const ByFaces& expected, int i) {
            return expected.place_of_vertex(i) == Place::degenerate;
        });
}

TEST_CASE("edges that leave the smaller of their vertices", "[points:1]") {
    hint("Can you tell from its number whether an edge leaves a vertex?");
    for (const Fixture& fixture : hidden::renumbered_copies()) {
        const OnMesh on(fixture);
        const ByFaces expected(fixture);
        const hidden::WingedFixture made = hidden::winged_fixture(fixture, 3);
        const WingedMesh mesh = all_forward(made.mesh);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const int v = expected.start(i);
            if (mesh.vertex[static_cast<std::size_t>(v)] ==
                made.directed[static_cast<std::size_t>(i)].edge)
                REQUIRE_THAT(winged_faces(mesh, v),
                             IsPermutationOf(faces_met(expected, i)));
        }
    }
}

TEST_CASE("vertices without edges", "[points:1]") {
    hint("What stands in mesh.vertex for a vertex that has no edge?");
    for (const Fixture& fixture :
         {hidden::gaps(), zoo::slide(), zoo::tetra()}) {
        const OnMesh on(fixture);
        WingedMesh mesh = hidden::winged_fixture(fixture, 5).mesh;
        mesh.vertex.insert(mesh.vertex.end(), {-1, -1});
        for (std::size_t v = 0; v < mesh.vertex.size(); ++v)
            if (mesh.vertex[v] == -1)
                REQUIRE(winged_faces(mesh, static_cast<int>(v)).empty());
        const int first = fixture.he.rows()[0].vi;
        REQUIRE_FALSE(winged_faces(mesh, first).empty());
    }
    CHECK(winged_faces(WingedMesh{{}, {-1}, {}}, 0).empty());
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint("Which of your steps relies on how edges are numbered or stored?");
    check(hidden::renumbered_copies(), 900, everywhere);
    check(generated_fixtures(), 1000, everywhere);
}
