// Meshes of any size: regular ones, and random polygon meshes for tests that
// compare two answers. The same arguments give the same faces everywhere;
// positions may differ in the last digit where the platform rounds otherwise.
#pragma once

#include <cstdint>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// What the cells of a regular mesh are.
enum class Cells {
    quads,
    triangles,  ///< each quad cut along one diagonal
};

/// The unit sphere: an icosahedron whose triangles are cut into four `levels`
/// times. V = 10 * 4^levels + 2, F = 20 * 4^levels, wound outwards.
/// Throws std::invalid_argument unless 0 <= levels <= 10. Linear.
IndexedMesh icosphere(int levels);

/// A torus round the z axis with radii 2 and 1: nu cells the long way round,
/// nv the short way. V = nu * nv, wound outwards.
/// Throws std::invalid_argument when nu or nv is below 3. Linear.
IndexedMesh torus(int nu, int nv, Cells cells = Cells::quads);

/// nx times ny unit cells in the plane z = 0, the first corner at the origin.
/// V = (nx + 1) * (ny + 1), row by row, wound counter-clockwise.
/// Throws std::invalid_argument when nx or ny is below 1. Linear.
IndexedMesh grid(int nx, int ny, Cells cells = Cells::quads);

/// Whether each part of a random mesh has a border.
enum class Surface {
    open,    ///< it has
    closed,  ///< it has none
    mixed,   ///< it has or not
    plane,   ///< it has, and all of it lies in one plane
};

/// Whether holes may touch each other and the border at a single vertex.
enum class BowTies { none, allowed };

/// What becomes of the vertices that no face uses any more.
enum class Unused { dropped, kept };

/// What random_polygons makes.
struct RandomMesh {
    int faces = 100;         ///< to start with, about; at least 9 when closed
    int parts = 1;           ///< pieces to start with; holes may cut one up
    int max_sides = 8;       ///< of a face, at least 4
    int merge_percent = 40;  ///< of the edges: where two faces become one
    int hole_percent = 5;    ///< of the faces of open parts: taken out
    Surface surface = Surface::open;
    BowTies bow_ties = BowTies::none;
    Unused unused = Unused::dropped;
};

/// A random polygon mesh that has a half-edge table: triangles to `max_sides`-
/// gons, spheres, tori and planes side by side, the open ones with holes. No
/// face comes to one vertex twice; two faces may share several edges. A merge
/// or a hole that would break that, or make a bow-tie where none is allowed, is
/// left out. The same seed and options give the same faces on every platform.
/// Throws std::invalid_argument when an option is out of its range. Linear for
/// a fixed `max_sides`.
IndexedMesh random_polygons(std::uint64_t seed, const RandomMesh& options = {});

}  // namespace course
