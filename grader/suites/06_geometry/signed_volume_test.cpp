// Hidden suite of signed_volume: bodies whose volume is known, and others
// measured by their height above the ground.
#include "exercises/06_geometry/signed_volume.h"

#include <algorithm>
#include <vector>

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/normals_meshes.h"
#include "grader/suites/06_geometry/normals_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

/// What a volume is measured by: the cube of the mesh's size.
double size_of(const IndexedMesh& mesh) {
    const auto at = [&](int v) {
        return mesh.positions[static_cast<std::size_t>(v)];
    };
    double across = 1e-9;
    for (const int v : mesh.faces.corners())
        across =
            std::max(across, length(at(v) - at(mesh.faces.corners().front())));
    return across * across * across;
}

void check_volume(const Fixture& fixture, double expected) {
    const OnMesh on(fixture);
    CHECK_THAT(signed_volume(fixture.mesh),
               IsAbout(expected, size_of(fixture.mesh)));
}

void check_measured(const Fixture& fixture) {
    check_volume(fixture, normals::volume_below(fixture.mesh));
}

Fixture inside_out(Fixture fixture) {
    FaceList turned;
    for (const auto face : fixture.mesh.faces) {
        std::vector<int> corners(face.rbegin(), face.rend());
        // The first corner stays the first: bent faces are cut as before.
        std::rotate(corners.begin(), corners.end() - 1, corners.end());
        turned.push_back(corners);
    }
    fixture.mesh.faces = turned;
    fixture.name += " inside out";
    return fixture;
}

Fixture stretched(Fixture fixture, Vec3 size, Vec3 shift) {
    for (Vec3& p : fixture.mesh.positions)
        p = Vec3{p.x * size.x, p.y * size.y, p.z * size.z} + shift;
    return fixture;
}

Fixture joined(Fixture a, const Fixture& b) {
    const int first = a.mesh.vertex_count();
    for (const Vec3 p : b.mesh.positions) a.mesh.positions.push_back(p);
    for (const auto face : b.mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        for (int& v : corners) v += first;
        a.mesh.faces.push_back(corners);
    }
    a.name += " and " + b.name;
    return a;
}

/// A comb of height 2: a strip that is 1 wide, and on every 2 of its length a
/// tooth that is 3 long. Top and bottom have 2 * teeth + 3 corners; they begin
/// at corner `first`.
Fixture comb(int teeth, std::size_t first) {
    std::vector<Vec3> outline;
    for (int k = 0; k <= teeth; ++k) {
        outline.push_back({2.0 * k, 0, 0});
        if (k < teeth) outline.push_back({2.0 * k + 1, 3, 0});
    }
    outline.push_back({2.0 * teeth, -1, 0});
    outline.push_back({0, -1, 0});
    std::reverse(outline.begin(), outline.end());
    const int n = static_cast<int>(outline.size());
    IndexedMesh mesh{outline, {}, {}};
    for (const Vec3 p : outline) mesh.positions.push_back(p + Vec3{0, 0, 2});
    std::vector<int> top, bottom;
    for (int k = 0; k < n; ++k) {
        top.push_back(n + k);
        bottom.insert(bottom.begin(), k);
        const int next = (k + 1) % n;
        mesh.faces.push_back({k, next, n + next, n + k});
    }
    const auto shift = static_cast<std::ptrdiff_t>(first);
    std::rotate(top.begin(), top.begin() + shift, top.end());
    std::rotate(bottom.begin(), bottom.begin() + shift, bottom.end());
    mesh.faces.push_back(top);
    mesh.faces.push_back(bottom);
    return {"comb", mesh, {}};
}

std::vector<Fixture> closed_meshes() {
    return {zoo::tetra(),
            zoo::cube(),
            zoo::house(),
            zoo::torus7(),
            zoo::hourglass(),
            hidden::prism(),
            hidden::bipyramid(),
            hidden::two_tori(),
            zoo::pillow(),
            hidden::ring_closed(),
            hidden::pinched_sphere()};
}

/// Closed random meshes, some of several parts.
std::vector<Fixture> random_closed() {
    std::vector<Fixture> all;
    for (std::uint64_t k = 0; k < 8; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k % 3);
        options.surface = Surface::closed;
        all.push_back({"random closed mesh",
                       random_polygons(seed() * 100 + k, options),
                       {}});
    }
    return all;
}

}  // namespace

TEST_CASE("boxes and pyramids", "[points:1]") {
    hint("Work out by hand what each face of the box adds.");
    for (const Vec3 size : {Vec3{1, 1, 1}, Vec3{1, 2, 3}, Vec3{5, 0.5, 0.25}})
        for (const Vec3 shift : {Vec3{}, Vec3{1, -2, 0.5}, Vec3{-3, -3, -3}}) {
            const double volume = size.x * size.y * size.z;
            const Fixture box = stretched(zoo::cube(), size, shift);
            check_volume(box, volume);
            check_volume(renumbered(box, 1), volume);
            check_volume(normals::cut_to_triangles(box), volume);
            check_volume(stretched(normals::box({1, 1, 1}), size, shift),
                         volume);
            check_volume(stretched(zoo::house(), size, shift), 1.25 * volume);
            check_volume(stretched(zoo::tetra(), size, shift),
                         -8 / 3.0 * volume);
        }
}

TEST_CASE("inside out is negative", "[points:1]") {
    hint("What becomes of the sign when all faces are turned round?");
    check_volume(inside_out(zoo::cube()), -1);
    check_volume(inside_out(zoo::tetra()), 8 / 3.0);
    for (const Fixture& fixture : closed_meshes()) {
        const double volume = normals::volume_below(fixture.mesh);
        check_volume(fixture, volume);
        check_volume(inside_out(fixture), -volume);
    }
}

TEST_CASE("faces with many corners", "[points:1]") {
    hint("Which triangles are the face cut into, and do you count all?");
    for (const int teeth : {1, 2, 5, 9})
        for (std::size_t first = 0; first < 5; ++first)
            check_volume(comb(teeth, first), 2.0 * (teeth * 3 + teeth * 2));
    for (std::uint64_t k = 0; k < 12; ++k)
        for (const Fixture& fixture : {hidden::prism(), zoo::cube()})
            check_measured(normals::at_random_points(fixture, 20 + k));
}

TEST_CASE("several parts, and a hollow", "[points:1]") {
    hint("What do the faces of a hollow look at, and what do they add?");
    const Fixture large = stretched(zoo::cube(), {4, 4, 4}, {});
    const Fixture small = stretched(zoo::cube(), {1, 2, 1}, {1, 1, 1});
    check_volume(joined(large, inside_out(small)), 62);
    check_volume(joined(inside_out(small), large), 62);
    check_volume(joined(large, stretched(small, {1, 1, 1}, {9, 9, 9})), 66);
    check_volume(joined(small, inside_out(small)), 0);
    for (const Fixture& fixture : random_closed()) check_measured(fixture);
}

TEST_CASE("closed meshes with their vertices anywhere", "[points:1]") {
    hint(
        "Is it dot(a, cross(b, c)) with a, b and c in this order, and a sixth "
        "of it?");
    std::uint64_t salt = 100;
    for (const Fixture& fixture : closed_meshes())
        for (int k = 0; k < 4; ++k) {
            ++salt;
            check_measured(
                normals::at_random_points(renumbered(fixture, salt), salt));
        }
    for (const Fixture& fixture : random_closed())
        check_measured(normals::at_random_points(fixture, ++salt));
}

TEST_CASE("turned, moved, small and large", "[points:1]") {
    hint("Twice as long, wide and high is how much more volume?");
    for (const Fixture& fixture : closed_meshes()) {
        const double volume = normals::volume_below(fixture.mesh);
        for (const normals::Motion& motion : normals::motions())
            check_volume(normals::moved(fixture, motion),
                         volume * motion.scale * motion.scale * motion.scale);
    }
}

TEST_CASE("far from the origin", "[points:1]") {
    hint(
        "Which numbers grow with the distance, and what is lost when they "
        "cancel out?");
    check_volume(normals::moved(zoo::cube(), normals::far_away()), 1);
    for (std::uint64_t k = 0; k < 10; ++k) {
        const Fixture fixture = normals::at_random_points(
            k % 2 == 0 ? zoo::house() : zoo::torus7(), 200 + k);
        check_volume(normals::moved(fixture, normals::far_away()),
                     normals::volume_below(fixture.mesh));
    }
}

TEST_CASE("vertices that no face uses", "[points:1]") {
    hint("Which vertices do you look at? Are all of them part of the mesh?");
    check_volume({"no faces", {{{1, 2, 3}, {4, 5, 6}}, {}, {{0, 1}}}, {}}, 0);
    check_volume({"empty mesh", {}, {}}, 0);
    const Fixture stray{"stray vertex", {{{3e8, -7e8, 5e8}}, {}, {}}, {}};
    for (std::uint64_t k = 0; k < 6; ++k) {
        const Fixture house = normals::at_random_points(zoo::house(), 300 + k);
        const double volume = normals::volume_below(house.mesh);
        check_volume(joined(house, stray), volume);
        check_volume(joined(stray, house), volume);
        Fixture loose = joined(joined(stray, house), stray);
        loose.mesh.loose_edges = {{0, 1}, {0, loose.mesh.vertex_count() - 1}};
        check_volume(loose, volume);
    }
}

TEST_CASE("large meshes", "[points:1]") {
    hint("How often do you go through the list of faces?");
    check_measured({"icosphere", icosphere(4), {}});
    check_measured({"torus", torus(80, 60), {}});
    check_measured({"torus", torus(90, 40, Cells::triangles), {}});
}
