// Hidden suite of outgoing.
#include "exercises/01_traversal/outgoing.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

namespace {

/// Anchors of a whole mesh: of each vertex and face some half-edge, of the
/// vertex that i leaves and the face of i just i.
Anchors anchors_by(const HalfEdgeTable& he, std::size_t vertices,
                   std::size_t faces, int i) {
    Anchors anchors;
    anchors.vertex.assign(vertices, -1);
    anchors.face.assign(faces, -1);
    const auto set = [&](int at) {
        const HalfEdge& row = he.rows()[static_cast<std::size_t>(at)];
        anchors.vertex[static_cast<std::size_t>(row.vi)] = at;
        if (row.fi != -1) anchors.face[static_cast<std::size_t>(row.fi)] = at;
    };
    for (int at = 0; at < he.size(); ++at) set(at);
    set(i);
    return anchors;
}

Anchors anchors_by(const Fixture& fixture, int i) {
    return anchors_by(fixture.he, fixture.mesh.positions.size(),
                      static_cast<std::size_t>(fixture.mesh.faces.size()), i);
}

bool everywhere(const ByFaces&, int) {
    return true;
}

/// Checks each half-edge of the mesh as the anchor of its vertex, where
/// where(expected, i) holds.
template <class Where>
void check(const Fixture& fixture, Where where) {
    const ByFaces expected(fixture);
    for (int i = 0; i < fixture.he.size(); ++i)
        if (where(expected, i))
            REQUIRE_THAT(
                outgoing(fixture.he, anchors_by(fixture, i), expected.start(i)),
                IsRotationOf(expected.outgoing(i)));
}

/// The same for each of the meshes.
template <class Where>
void check(const std::vector<Fixture>& fixtures, Where where) {
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        check(fixture, where);
    }
}

}  // namespace

TEST_CASE("vertices with faces all round, by each possible anchor",
          "[points:2]") {
    hint(
        "Which two steps bring you from one half-edge that leaves v to the "
        "next one?");
    check(hidden::made_by_hand(), [](const ByFaces& expected, int i) {
        return expected.place_of_vertex(i) == Place::interior;
    });
}

TEST_CASE("vertices on the border, by each possible anchor", "[points:1]") {
    hint("Does a half-edge without a face leave the vertex all the same?");
    check(hidden::made_by_hand(), [](const ByFaces& expected, int i) {
        return expected.place_of_vertex(i) == Place::border;
    });
}

TEST_CASE("loose edges, bow-ties, and a face that is met twice", "[points:1]") {
    hint(
        "Which half-edges does the walk from the anchor meet before it is "
        "back?");
    check(hidden::made_by_hand(), [](const ByFaces& expected, int i) {
        return expected.place_of_vertex(i) == Place::degenerate;
    });
}

TEST_CASE("vertices that no half-edge leaves", "[points:1]") {
    hint("What is the anchor of such a vertex, and is it a half-edge?");
    const Fixture gaps = hidden::gaps();
    const OnMesh on(gaps);
    const Anchors anchors = anchors_by(gaps, 0);
    for (int v = 0; v < gaps.mesh.vertex_count(); ++v) {
        const int anchor = anchors.vertex[static_cast<std::size_t>(v)];
        if (anchor == -1)
            REQUIRE(outgoing(gaps.he, anchors, v).empty());
        else
            REQUIRE_THAT(outgoing(gaps.he, anchors, v),
                         IsRotationOf(ByFaces(gaps).outgoing(anchor)));
    }
    CHECK(outgoing({}, Anchors{{-1}, {}}, 0).empty());
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint(
        "Which of your steps relies on how the table is numbered, or on "
        "which half-edge the anchor is?");
    check(hidden::renumbered_copies(), everywhere);
    on_generated_meshes(generated_fixtures(), [](const Fixture& fixture) {
        check(fixture, everywhere);
    });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one vertex?");
    // Few calls: each sends the anchors of the whole mesh.
    constexpr int calls = 5;
    const LargeMesh& large = a_million_half_edges();
    Anchors anchors =
        anchors_by(large.he, large.vertices.size(), large.faces.size(), 0);
    hidden::for_some_of_a_million(
        calls, 200, hidden::starts_within,
        [&](const HalfEdgeTable& he, const InLargeMesh& at,
            const ByFaces& expected) {
            const int v = at.mesh->vertices(expected.start(at.i), at.copy);
            anchors.vertex[static_cast<std::size_t>(v)] = at.row();
            REQUIRE_THAT(outgoing(he, anchors, v),
                         IsRotationOf(at.half_edges(expected.outgoing(at.i))));
        });
}
