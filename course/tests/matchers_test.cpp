// The matchers that suites share: what they let through, and what they say.
#include <limits>

#include "course/halfedge/build.h"
#include "course/halfedge/renumber.h"
#include "course/runner/geometry.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class T, class Matcher>
std::string complaint(const T& got, const Matcher& matcher) {
    return matcher.match(got) ? "" : matcher.describe();
}

}  // namespace

TEST_CASE("measures are compared relative to their size") {
    CHECK_THAT(1e6 + 1e-4, IsAbout(1e6));
    CHECK_THAT(1e6 + 1e-2, !IsAbout(1e6));
    CHECK_THAT(1e-12, IsAbout(0, 1));
    CHECK_THAT(1e-6, !IsAbout(0, 1));
    CHECK_THAT(not_a_number, !IsAbout(1));
    CHECK_THAT(1.0, !IsAbout(not_a_number));
    CHECK(complaint(2.0, IsAbout(1)) == "is about: 1.0 (it is 1 off)");
}

TEST_CASE("points are compared relative to the mesh that they belong to") {
    CHECK_THAT((Vec3{1, 2, 3 + 1e-8}), IsAt({1, 2, 3}, 100));
    CHECK_THAT((Vec3{1, 2, 3 + 1e-8}), !IsAt({1, 2, 3}, 1));
    CHECK_THAT((Vec3{not_a_number, 2, 3}), !IsAt({1, 2, 3}, 100));
    const std::vector<Vec3> one = {{0, 0, 0}}, two = {{0, 0, 0}, {1, 0, 0}};
    CHECK_THAT(two, AreAt(two, 1));
    CHECK_THAT(one, !AreAt(two, 1));
    const auto why = complaint(two, AreAt({{0, 0, 0}, {2, 0, 0}}, 1));
    CHECK(why.find("element 1: it is 1 away") != std::string::npos);
}

TEST_CASE("directions are compared by their angle and have unit length") {
    CHECK_THAT((Vec3{0, 0, 1}), IsDirection({0, 0, 7}));
    CHECK_THAT((Vec3{0, 0, -1}), !IsDirection({0, 0, 7}));
    CHECK_THAT((Vec3{0, 0, 2}), !IsDirection({0, 0, 7}));
    CHECK_THAT((Vec3{0, 0, 0}), !IsDirection({0, 0, 7}));
    CHECK_THAT((Vec3{not_a_number, not_a_number, not_a_number}),
               !IsDirection({0, 0, 7}));
    CHECK_THAT((Vec3{0, 0, 0}), IsDirection({0, 0, 0}));
    CHECK_THAT((Vec3{0, 0, 1}), !IsDirection({0, 0, 0}));
    const auto why = complaint(Vec3{0, 1, 0}, IsDirection({0, 0, 1}));
    CHECK(why.find("turned by 90 degrees") != std::string::npos);
}

TEST_CASE("a table is right under any numbers of its half-edges") {
    for (const Fixture& fixture : zoo::with_table()) {
        INFO(fixture.name);
        CHECK(difference(fixture.he, fixture.mesh).empty());
        CHECK(difference(renumber(fixture.he, 7), fixture.mesh).empty());
        const Fixture other = renumbered(fixture);
        CHECK(difference(other.he, other.mesh).empty());
    }
}

TEST_CASE("what is wrong with a table is told") {
    const Fixture slide = zoo::slide();
    const auto told = [&](const HalfEdgeTable& he, const IndexedMesh& mesh) {
        return difference(he, mesh);
    };
    HalfEdgeTable broken = slide.he;
    broken[12].opp = 7;
    CHECK(told(broken, slide.mesh).find("half-edge 6") != std::string::npos);
    CHECK(told(HalfEdgeTable(), slide.mesh) ==
          "the table has 0 faces, expected 3");
    IndexedMesh other = slide.mesh;
    other.faces = {{0, 2, 1}, {1, 2, 4, 5}, {2, 3, 5}};
    CHECK(told(slide.he, other).rfind("face 1 runs along", 0) == 0);
    CHECK(told(zoo::dangling().he, slide.mesh).find("edge 4-6") !=
          std::string::npos);
    CHECK(told(slide.he, zoo::dangling().mesh) ==
          "the loose edge 4-6 is missing");
    HalfEdgeTable gap = slide.he;
    for (HalfEdge& row : gap)
        if (row.fi == 2) row.fi = 1 << 30;
    CHECK(told(gap, slide.mesh) == "no half-edge runs along face 2");
}
