// Meshes and motions for the suites on normals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "course/mesh/mat3.h"
#include "course/mesh/zoo.h"

namespace course::normals {

/// Turns, then scales, then moves. A turn keeps left and right apart.
struct Motion {
    std::string name;
    Mat3 turn;
    double scale = 1;
    Vec3 shift;

    Vec3 direction(Vec3 n) const { return turn * n; }
    Vec3 point(Vec3 p) const { return scale * (turn * p) + shift; }
};

/// None, a thousandth as large, ten thousand times as large, turned, and all at
/// once. Points near the origin, of size 1, lose nothing that could be seen.
std::vector<Motion> motions();

/// A shift by some millions. It loses nothing of points whose coordinates are
/// small multiples of 1/1024.
Motion far_away();

std::vector<Vec3> moved(std::vector<Vec3> points, const Motion& motion);
Fixture moved(Fixture fixture, const Motion& motion);

/// Points in the cube from -1 to 1, the coordinates multiples of 1/1024; from
/// the seed of the run and `salt`.
std::vector<Vec3> random_points(int count, std::uint64_t salt);

/// The same mesh with its vertices at random points.
Fixture at_random_points(Fixture fixture, std::uint64_t salt);

/// The same mesh, each face cut into the triangles round its first corner.
Fixture cut_to_triangles(const Fixture& fixture);

/// Each with a table of triangles: of the zoo, cut where needed, and those
/// hidden ones whose faces can be cut so.
std::vector<Fixture> triangle_meshes();

/// The box from the origin to `size`, twelve triangles. At its corners one or
/// two triangles of each side meet.
Fixture box(Vec3 size);

/// A tetrahedron without a volume, in a plane that is parallel to none of the
/// axes: its fourth vertex lies on an edge of the triangle of the other three.
/// The faces at vertex 0 cancel out by area and by angle, and face 3 is
/// degenerate.
Fixture flat_tetra();

/// The fixture as it is in each of `motions()`.
std::vector<Fixture> in_all_motions(const Fixture& fixture);

}  // namespace course::normals
