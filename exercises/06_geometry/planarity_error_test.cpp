#include "exercises/06_geometry/planarity_error.h"

#include <vector>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the quads of the statement", "[points:1]") {
    hint("Where is the mean plane, and how far is each corner from it?");
    const auto flat = planarity_error(
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    REQUIRE(flat.has_value());
    CHECK_THAT(*flat, IsAbout(0, 1));
    const auto bent = planarity_error(
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}});
    REQUIRE(bent.has_value());
    CHECK_THAT(*bent, IsAbout(0.5));
    const auto lifted = planarity_error(
        std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 1}});
    REQUIRE(lifted.has_value());
    CHECK_THAT(*lifted, IsAbout(1 / std::sqrt(18.0)));
}

TEST_CASE("corners on a line have no mean plane", "[points:1]") {
    hint("How long is the area vector, and what do you compare it with?");
    CHECK(planarity_error(std::vector<Vec3>{
              {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}) == std::nullopt);
}

TEST_CASE("two corners are no polygon", "[points:1]") {
    hint("What is asked first, before any corner is looked at?");
    CHECK_THROWS_AS(planarity_error(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}),
                    std::invalid_argument);
}
