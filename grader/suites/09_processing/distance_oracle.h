// The distance of two surfaces, found by searching: in a triangle, the distance
// from a point is a convex function of where one looks.
#pragma once

#include "course/mesh/indexed_mesh.h"

namespace course::oracle {

/// As the exercise defines it. Some hundred steps for each vertex and triangle.
/// Precondition: triangles, at least one in each mesh.
double surface_distance(const IndexedMesh& a, const IndexedMesh& b);

/// The same, from the used vertices of `from` to the surface of `to` only.
double one_way_distance(const IndexedMesh& from, const IndexedMesh& to);

}  // namespace course::oracle
