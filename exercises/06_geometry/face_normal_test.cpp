#include "exercises/06_geometry/face_normal.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("unit length, on the side that sees a, b, c counter-clockwise",
          "[points:1]") {
    hint("How long is your vector, and to which side does it point?");
    const auto normal = face_normal({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
    REQUIRE(normal.has_value());
    CHECK_THAT(*normal, IsDirection({0, 0, 1}));
    const auto back = face_normal({0, 0, 0}, {0, 4, 0}, {3, 0, 0});
    REQUIRE(back.has_value());
    CHECK_THAT(*back, IsDirection({0, 0, -1}));
}

TEST_CASE("a tiny triangle has a normal, too", "[points:1]") {
    hint("Small compared with what?");
    const auto normal = face_normal({0, 0, 0}, {0, 1e-9, 0}, {0, 0, 1e-9});
    REQUIRE(normal.has_value());
    CHECK_THAT(*normal, IsDirection({1, 0, 0}));
}

TEST_CASE("a degenerate triangle has none", "[points:1]") {
    hint(
        "What is the length of the area vector here, and what happens when "
        "you divide by it?");
    CHECK(face_normal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}) == std::nullopt);
    CHECK(face_normal({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.3, 0.6, 0.9}) ==
          std::nullopt);
}
