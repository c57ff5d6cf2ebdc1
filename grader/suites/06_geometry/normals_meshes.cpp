#include "grader/suites/06_geometry/normals_meshes.h"

#include <random>

#include "course/halfedge/build.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

namespace course::normals {

namespace {

constexpr Mat3 no_turn{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

/// A turn about no axis in particular, of numbers that are exact up to the
/// division by nine.
Mat3 some_turn() {
    return {{(1 / 9.0) * Vec3{1, -8, 4}, (1 / 9.0) * Vec3{4, 4, 7},
             (1 / 9.0) * Vec3{-8, 1, 4}}};
}

Fixture with_table(std::string name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

}  // namespace

std::vector<Motion> motions() {
    return {
        {"", no_turn, 1, {}},
        {", a thousandth as large", no_turn, 1e-3, {}},
        {", ten thousand times as large", no_turn, 1e4, {}},
        {", turned", some_turn(), 1, {}},
        {", turned, small and moved", some_turn(), 1e-3, {3e-3, -2e-3, 1e-3}},
        {", turned, large and moved", some_turn(), 1e4, {1e4, 2e4, -3e4}}};
}

Motion far_away() {
    return {", far from the origin",
            no_turn,
            1,
            {double{1 << 20}, -double{1 << 21}, double{1 << 19}}};
}

std::vector<Vec3> moved(std::vector<Vec3> points, const Motion& motion) {
    for (Vec3& p : points) p = motion.point(p);
    return points;
}

Fixture moved(Fixture fixture, const Motion& motion) {
    fixture.name += motion.name;
    fixture.mesh.positions = moved(std::move(fixture.mesh.positions), motion);
    return fixture;
}

std::vector<Vec3> random_points(int count, std::uint64_t salt) {
    std::mt19937_64 random(seed() * 1000 + salt);
    const auto coordinate = [&] {
        return static_cast<double>(random() % 2049) / 1024 - 1;
    };
    std::vector<Vec3> points(static_cast<std::size_t>(count));
    for (Vec3& p : points) {
        p.x = coordinate();
        p.y = coordinate();
        p.z = coordinate();
    }
    return points;
}

Fixture at_random_points(Fixture fixture, std::uint64_t salt) {
    fixture.mesh.positions = random_points(fixture.mesh.vertex_count(), salt);
    return fixture;
}

Fixture cut_to_triangles(const Fixture& fixture) {
    IndexedMesh cut = fixture.mesh;
    cut.faces = {};
    for (const auto face : fixture.mesh.faces)
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            cut.faces.push_back({face[0], face[k], face[k + 1]});
    return with_table(fixture.name + " in triangles", std::move(cut));
}

std::vector<Fixture> triangle_meshes() {
    std::vector<Fixture> all = {zoo::triangle(),
                                zoo::tetra(),
                                zoo::torus7(),
                                zoo::fan6(),
                                zoo::two_triangles(),
                                zoo::hourglass(),
                                zoo::bow_tie_crossed(),
                                zoo::bow_tie_separate(),
                                zoo::pillow(),
                                hidden::pinwheel_in_turn(),
                                hidden::pinwheel_across(),
                                hidden::pinwheel_split(),
                                hidden::bipyramid(),
                                hidden::bridge(),
                                hidden::loose_pair(),
                                hidden::loose_chain(),
                                hidden::gaps()};
    std::erase_if(all, [](const Fixture& fixture) {
        for (const auto face : fixture.mesh.faces)
            if (face.size() != 3) return true;
        return false;
    });
    for (const Fixture& fixture :
         {zoo::slide(), zoo::cube(), zoo::house(), zoo::annulus(),
          zoo::dangling(), hidden::prism(), hidden::twelve_gon(),
          hidden::two_tori(), hidden::open_then_closed(),
          hidden::closed_then_open()})
        all.push_back(cut_to_triangles(fixture));
    return all;
}

Fixture box(Vec3 size) {
    Fixture cube = zoo::cube();
    for (Vec3& p : cube.mesh.positions)
        p = {p.x * size.x, p.y * size.y, p.z * size.z};
    Fixture fixture = cut_to_triangles(cube);
    fixture.name = "box";
    return fixture;
}

//      2
//      |\.        F0 = (0,2,1), seen from behind
//      | \.       F1 = (0,1,3)  F2 = (0,3,2)
//      |  3       F3 = (1,2,3), on one line
//      | /  \.    V 4, E 6, F 4, chi 2, no loop
//      |/     \.
//      0--------1
Fixture flat_tetra() {
    const Vec3 a{0.1, 0.2, 0.3}, b{1.4, 0.3, 0.9}, c{0.2, 1.7, 0.4};
    const Vec3 on_edge = b + 0.6 * (c - b);
    return with_table(
        "flat tetrahedron",
        {{a, b, c, on_edge}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}});
}

std::vector<Fixture> in_all_motions(const Fixture& fixture) {
    std::vector<Fixture> all;
    for (const Motion& motion : motions())
        all.push_back(moved(fixture, motion));
    return all;
}

}  // namespace course::normals
