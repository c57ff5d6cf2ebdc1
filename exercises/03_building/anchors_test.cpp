#include "exercises/03_building/anchors.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("each vertex of the slide mesh has a half-edge that leaves it",
          "[points:1]") {
    hint("Does the half-edge leave the vertex, or does it arrive there?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Anchors found = anchors(slide.he, 6, 3);
    REQUIRE(found.vertex.size() == 6);
    int v = 0;
    for (const int i : found.vertex) {
        INFO("vertex " << v << " got half-edge " << i);
        REQUIRE((0 <= i && i < slide.he.size()));
        CHECK(slide.he[i].vi == v);
        ++v;
    }
}

TEST_CASE("each face of the slide mesh has a half-edge along it",
          "[points:1]") {
    hint("Which half-edges run along no face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Anchors found = anchors(slide.he, 6, 3);
    REQUIRE(found.face.size() == 3);
    int f = 0;
    for (const int i : found.face) {
        INFO("face " << f << " got half-edge " << i);
        REQUIRE((0 <= i && i < slide.he.size()));
        CHECK(slide.he[i].fi == f);
        ++f;
    }
}
