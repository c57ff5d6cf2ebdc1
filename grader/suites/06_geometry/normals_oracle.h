// What the suites on normals compare with: other formulas than the exercises
// ask for, in extended precision, on corners from the face list.
#pragma once

#include <span>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course::normals {

/// The corners of face f, in the order of the face list.
std::vector<Vec3> corners_of(const IndexedMesh& mesh, int f);

/// Twice the areas of the polygon's shadows on the planes x = 0, y = 0 and
/// z = 0, with signs: the polygon's area vector, twice its area long.
Vec3 twice_shadows(std::span<const Vec3> corners);

/// The sum of the cross products of the two sides at each corner.
Vec3 sum_over_corners(std::span<const Vec3> corners);

/// The sum of the squares of the sides.
double squared_sides(std::span<const Vec3> corners);

/// The angle at `at` between the directions to p and q, from the three sides.
double angle_at(Vec3 at, Vec3 p, Vec3 q);

/// The volume below the faces, down to the height of some corner: triangles
/// round the first corner of each face, their shadow on the ground times
/// their mean height.
double volume_below(const IndexedMesh& mesh);

}  // namespace course::normals
