#include "exercises/01_traversal/outgoing.h"

#include <algorithm>

#include "course/runner/for_each_half_edge.h"

using namespace course;

namespace {

/// Of each number up to `count`, the first row with it in that column.
std::vector<int> first_rows(const HalfEdgeTable& he, int HalfEdge::*column,
                            int count) {
    std::vector<int> first;
    for (int number = 0; number < count; ++number) {
        const auto row = std::ranges::find(he.rows(), number, column);
        first.push_back(static_cast<int>(row - he.rows().begin()));
    }
    return first;
}

}  // namespace

TEST_CASE("the half-edges that leave the vertices of the slide mesh",
          "[points:2]") {
    hint("Which half-edge do you begin with, and who tells you?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Anchors anchors{{1, 4, 3, 9, 7, 8}, {1, 4, 8}};
    CHECK_THAT(outgoing(slide.he, anchors, 0), IsRotationOf({1, 2}));
    CHECK_THAT(outgoing(slide.he, anchors, 1), IsRotationOf({4, 5, 6}));
    CHECK_THAT(outgoing(slide.he, anchors, 2), IsRotationOf({3, 11, 14, 0}));
    CHECK_THAT(outgoing(slide.he, anchors, 3), IsRotationOf({9, 13}));

    const Anchors others{{2, 6, 14, 13, 12, 15}, {5, 15, 9}};
    CHECK_THAT(outgoing(slide.he, others, 2), IsRotationOf({3, 11, 14, 0}));
    CHECK_THAT(outgoing(slide.he, others, 5), IsRotationOf({8, 15, 10}));
}

TEST_CASE("nothing leaves an isolated vertex", "[points:1]") {
    hint("What does the anchor -1 say?");
    Fixture slide = zoo::slide();
    slide.mesh.positions.push_back({3, 2});
    const OnMesh on(slide);
    const Anchors anchors{{1, 4, 3, 9, 7, 8, -1}, {1, 4, 8}};
    CHECK(outgoing(slide.he, anchors, 6).empty());
    CHECK_THAT(outgoing(slide.he, anchors, 4), IsRotationOf({7, 12}));
}

TEST_CASE("what leaves vertices, on generated meshes", "[points:1]") {
    hint("Which of your steps relies on which half-edge the anchor is?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        const oracle::ByFaces expected(mesh);
        Anchors anchors{
            first_rows(mesh.he, &HalfEdge::vi, mesh.mesh.vertex_count()),
            first_rows(mesh.he, &HalfEdge::fi, mesh.mesh.faces.size())};
        for (int i = 0; i < mesh.he.size(); ++i) {
            const int v = expected.start(i);
            anchors.vertex[static_cast<std::size_t>(v)] = i;
            REQUIRE_THAT(outgoing(mesh.he, anchors, v),
                         IsRotationOf(expected.outgoing(i)));
        }
    });
}
