#include "exercises/04_topology/orient.h"

#include <algorithm>
#include <set>
#include <utility>

#include "course/runner/suite.h"

using namespace course;

namespace {

/// Whether no two sides run alike when the faces with a flag are turned over.
bool agrees(const IndexedMesh& mesh, const std::vector<bool>& flags) {
    std::set<std::pair<int, int>> sides;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            std::pair<int, int> side = {face[k], face[(k + 1) % face.size()]};
            if (flags[static_cast<std::size_t>(f)])
                std::swap(side.first, side.second);
            if (!sides.insert(side).second) return false;
        }
    }
    return true;
}

void check_orientable(const Fixture& fixture) {
    const OnMesh on(fixture);
    const std::optional<std::vector<bool>> flags = orient(fixture.mesh);
    REQUIRE(flags.has_value());
    REQUIRE(std::ssize(*flags) == fixture.mesh.faces.size());
    INFO("flags: " << show(*flags));
    CHECK(agrees(fixture.mesh, *flags));
}

void check_not_orientable(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(orient(fixture.mesh) == std::nullopt);
}

}  // namespace

TEST_CASE("the slide mesh with its quad turned over", "[points:1]") {
    hint("Of which face does the quad learn that it must be turned?");
    Fixture turned = zoo::slide();
    turned.mesh.faces = {{0, 2, 1}, {4, 5, 2, 1}, {2, 3, 5}};
    turned.he = {};
    check_orientable(turned);
}

TEST_CASE("an annulus has two sides, a Moebius band has one", "[points:1]") {
    hint("You come back to the first face. Must it be turned over again?");
    check_orientable(zoo::annulus());
    check_not_orientable(zoo::moebius3q());
}

TEST_CASE("three faces at one edge cannot agree", "[points:1]") {
    hint("Are all pairs of the three compatible?");
    check_orientable(zoo::torus7());
    check_not_orientable(zoo::fan3());
}
