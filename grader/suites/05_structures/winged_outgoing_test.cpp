// Hidden suite of winged_outgoing. The structures are made with random numbers
// and directions; what is expected comes from the face list.
#include "exercises/05_structures/winged_outgoing.h"

#include <algorithm>

#include "course/runner/by_faces.h"
#include "course/runner/suite.h"
#include "grader/suites/05_structures/winged_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

namespace {

using List = std::vector<DirectedEdge>;

List from_smallest(List list) {
    std::rotate(list.begin(), std::min_element(list.begin(), list.end()),
                list.end());
    return list;
}

ListMatcher<List> is_rotation_of(const List& expected) {
    return {expected, from_smallest, "is a rotation of: "};
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
        const auto directed = [&](int i) {
            return made.directed[static_cast<std::size_t>(i)];
        };
        for (int i = 0; i < fixture.he.size(); ++i) {
            if (!where(expected, i)) continue;
            const int v = expected.start(i);
            made.mesh.vertex[static_cast<std::size_t>(v)] = directed(i).edge;
            List leaving;
            for (const int k : expected.outgoing(i))
                leaving.push_back(directed(k));
            REQUIRE_THAT(winged_outgoing(made.mesh, v),
                         is_rotation_of(leaving));
        }
    }
}

bool everywhere(const ByFaces&, int) {
    return true;
}

}  // namespace

TEST_CASE("vertices with faces all round", "[points:2]") {
    hint("Which two steps of the half-edge walk make one step here?");
    for (const std::uint64_t salt : {100U, 200U, 300U})
        check(hidden::made_by_hand(), salt, [](const ByFaces& expected, int i) {
            return expected.place_of_vertex(i) == Place::interior;
        });
}

TEST_CASE("vertices on the border", "[points:2]") {
    hint("Does a half-edge along a side without a face leave the vertex, too?");
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

TEST_CASE("vertices without edges", "[points:1]") {
    hint("What stands in mesh.vertex for a vertex that has no edge?");
    for (const Fixture& fixture :
         {hidden::gaps(), zoo::slide(), zoo::tetra()}) {
        const OnMesh on(fixture);
        WingedMesh mesh = hidden::winged_fixture(fixture, 5).mesh;
        mesh.vertex.insert(mesh.vertex.end(), {-1, -1});
        for (std::size_t v = 0; v < mesh.vertex.size(); ++v)
            if (mesh.vertex[v] == -1)
                REQUIRE(winged_outgoing(mesh, static_cast<int>(v)).empty());
        const int first = fixture.he.rows()[0].vi;
        REQUIRE_FALSE(winged_outgoing(mesh, first).empty());
    }
    CHECK(winged_outgoing(WingedMesh{{}, {-1}, {}}, 0).empty());
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint("Which of your steps relies on how edges are numbered or stored?");
    check(hidden::renumbered_copies(), 900, everywhere);
    check(generated_fixtures(), 1000, everywhere);
}
