// Hidden suite of vertex_faces.
#include "exercises/01_traversal/vertex_faces.h"

#include <algorithm>

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

namespace {

/// The numbers of a list, each where it stands first.
std::vector<int> once_each(const std::vector<int>& list) {
    std::vector<int> once;
    for (const int f : list)
        if (std::ranges::find(once, f) == once.end()) once.push_back(f);
    return once;
}

/// What the walk that meets the faces `met` may answer. Where it meets one
/// twice, that depends on where it begins: the answer that `got` fits, if any.
std::vector<int> in_order(const std::vector<int>& got, std::vector<int> met) {
    for (std::size_t k = 0; k < met.size(); ++k) {
        const std::vector<int> answer = once_each(met);
        if (IsRotationOf(answer).match(got)) return answer;
        std::rotate(met.begin(), met.begin() + 1, met.end());
    }
    return once_each(met);
}

void check(const HalfEdgeTable& he, int i, const ByFaces& expected) {
    const std::vector<int> got = vertex_faces(he, i);
    REQUIRE_THAT(got, IsRotationOf(in_order(got, expected.faces_met(i))));
}

}  // namespace

TEST_CASE("vertices with faces all round", "[points:2]") {
    hint("Which two steps bring you from one edge of the vertex to the next?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::interior)
                check(he, i, expected);
        });
}

TEST_CASE("vertices on the border, from each half-edge that leaves them",
          "[points:1]") {
    hint("What is fi where there is no face, and is that a face?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::border)
                check(he, i, expected);
        });
}

TEST_CASE("loose edges, bow-ties, and a face that is met twice", "[points:1]") {
    hint(
        "How often does your walk meet this face, and how often do you list "
        "it?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::degenerate)
                check(he, i, expected);
        });
    const Fixture spur = hidden::spur();
    const OnMesh on(spur);
    CHECK(vertex_faces(spur.he, hidden::half_edge(spur, 0, 1)) ==
          std::vector{0});
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(hidden::renumbered_copies(), check);
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(check);
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one vertex?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::starts_within,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE_THAT(vertex_faces(he, at.row()),
                         IsRotationOf(at.faces(expected.faces_met(at.i))));
        });
}
