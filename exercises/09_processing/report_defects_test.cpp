#include "exercises/09_processing/report_defects.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a sound mesh has borders and components only", "[points:1]") {
    hint("Which edges have one face? Which faces share an edge?");
    const Fixture annulus = zoo::annulus();
    const OnMesh on(annulus);
    const DefectReport got = report_defects(annulus.mesh);
    CHECK(got.borders == 2);
    CHECK(got.components == 1);
    CHECK(got == DefectReport{{}, {}, {}, {}, {}, {}, 2, 1});
    CHECK(report_defects(zoo::cube().mesh) ==
          DefectReport{{}, {}, {}, {}, {}, {}, 0, 1});
}

TEST_CASE("three pages on an edge, and a wall in a house", "[points:1]") {
    hint("How many faces has each edge?");
    const Fixture book = zoo::fan3();
    const OnMesh on(book);
    CHECK(report_defects(book.mesh) ==
          DefectReport{{}, {}, {{0, 1}}, {}, {}, {}, 1, 1});
    CHECK(report_defects(zoo::house_with_wall().mesh) ==
          DefectReport{
              {}, {}, {{4, 5}, {4, 6}, {5, 7}, {6, 7}}, {}, {}, {}, 0, 1});
}

TEST_CASE("two tetrahedra that touch at a vertex", "[points:1]") {
    hint("Can you go round the vertex from each face to each other one?");
    const Fixture hourglass = zoo::hourglass();
    const OnMesh on(hourglass);
    CHECK(report_defects(hourglass.mesh) ==
          DefectReport{{}, {}, {}, {}, {0}, {}, 0, 2});
}

TEST_CASE("faces that are none, and faces that are there twice", "[points:1]") {
    hint("Which faces take no part in anything else?");
    Fixture mesh = zoo::slide();
    mesh.he = {};
    mesh.mesh.faces.push_back({2, 1, 0});      // F0, begun elsewhere
    mesh.mesh.faces.push_back({0, 1, 1});      // degenerate
    mesh.mesh.positions.push_back({0, 0, 5});  // isolated
    const OnMesh on(mesh);
    CHECK(report_defects(mesh.mesh) ==
          DefectReport{{4}, {3}, {}, {}, {}, {6}, 1, 1});
}
