// Drawings of meshes: what they show, and tables that are broken.
#include "course/report/mesh_drawing.h"

#include <limits>

#include "course/mesh/zoo.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace course;
using namespace grader;
using namespace grader::tests;

namespace {

int count(const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != text.npos;
         at = text.find(what, at + 1))
        ++n;
    return n;
}

std::string drawn(const MeshPicture& mesh, const course::Walk& walk = {}) {
    return mesh_drawing(mesh, walk).text;
}

bool has_only_numbers(const std::string& svg) {
    return svg.find("nan") == svg.npos && svg.find("inf") == svg.npos;
}

}  // namespace

TEST_CASE("every vertex, edge, face and half-edge is drawn") {
    const std::string svg = drawn(slide_picture());
    CHECK(count(svg, "<circle") == 6);
    CHECK(count(svg, "<line class=\"edge\"") == 8);
    CHECK(count(svg, "<line class=\"he\"") == 10);
    CHECK(count(svg, "<line class=\"he border\"") == 6);
    CHECK(count(svg, "<polygon class=\"face\"") == 3);
    for (const char* name : {">F0<", ">F1<", ">F2<", ">V5<", ">15<"})
        CHECK(count(svg, name) == 1);
}

TEST_CASE("the walk is set off, with the order of its steps") {
    const Failure failure = wrong_count();
    const std::string svg =
        drawn(failure.mesh, course::walk_of(failure.walk, failure.reads));
    CHECK(count(svg, "<line class=\"he walked\"") == 3);
    CHECK(count(svg, "class=\"step\"") == 3);
}

TEST_CASE("in space the faces that are turned away are not filled") {
    const std::string svg = drawn(tetra_picture());
    CHECK(count(svg, "<polygon class=\"face\"") == 2);
    CHECK(count(svg, "face-label behind") == 2);
}

TEST_CASE("every mesh of the zoo can be drawn") {
    for (const course::Fixture& one : course::zoo::with_table()) {
        CAPTURE(one.name);
        const MeshPicture picture = {one.name, one.he.rows(),
                                     one.mesh.positions};
        const std::string svg = drawn(picture);
        CHECK(has_only_numbers(svg));
        CHECK(count(svg, "class=\"number\"") == one.he.size());
    }
}

TEST_CASE("without positions that can be used the vertices lie on a circle") {
    MeshPicture mesh = slide_picture();
    mesh.positions.clear();
    const std::string circle = drawn(mesh);
    CHECK(count(circle, "<circle") == 6);
    const double bad = std::numeric_limits<double>::quiet_NaN();
    for (const std::vector<Vec3>& positions :
         {std::vector<Vec3>(3), std::vector<Vec3>(6),
          std::vector<Vec3>(6, Vec3{bad, bad, bad}),
          std::vector<Vec3>{
              {0, 0}, {1, 0}, {2, 0}, {1e300, 0}, {0, 1}, {bad, 0}},
          std::vector<Vec3>{
              {0, 0}, {1, 0}, {2, 0}, {1e308, 0}, {0, 1}, {-1e308, 0}}}) {
        mesh.positions = positions;
        CHECK(drawn(mesh) == circle);
    }
}

TEST_CASE("a table with any one field broken is drawn as far as it goes") {
    const MeshPicture whole = slide_picture();
    for (std::size_t i = 0; i < whole.rows.size(); ++i)
        for (int field = 0; field < 4; ++field)
            for (const int value :
                 {-2147483647 - 1, -1, 0, 3, 16, 1000000, 2147483647}) {
                MeshPicture mesh = whole;
                HalfEdge& row = mesh.rows[i];
                (field == 0   ? row.vi
                 : field == 1 ? row.fi
                 : field == 2 ? row.next
                              : row.opp) = value;
                REQUIRE(has_only_numbers(drawn(mesh)));
            }
}

TEST_CASE("meshes that are empty or too large are not drawn") {
    CHECK(drawn({}).empty());
    CHECK(drawn({"none", {{-1, -1, -1, -1}}, {}}).empty());
    MeshPicture large;
    large.rows.assign(most_drawn_half_edges + 1, {0, 0, 0, 0});
    CHECK(drawn(large).empty());
    large.rows.pop_back();
    CHECK(has_only_numbers(drawn(large)));
}

TEST_CASE("one edge alone, and one vertex alone, are drawn") {
    CHECK(count(drawn({"e", {{0, -1, 1, 1}, {1, -1, 0, 0}}, {}}), "<circle") ==
          2);
    CHECK(count(drawn({"v", {{0, -1, 0, 0}}, {}}), "<circle") == 1);
}

TEST_CASE("the name of a mesh is escaped") {
    MeshPicture mesh = slide_picture();
    mesh.name = "\"><script>";
    CHECK_THAT(drawn(mesh),
               Containing("Mesh &quot;&gt;&lt;script&gt; with 16"));
}
