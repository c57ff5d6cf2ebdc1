#pragma once

#include <span>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "exercises/06_geometry/area_vector.h"

/// The normal of the face that half-edge i runs along, by its wedges: the unit
/// vector in the direction of the sum, over all corners of the face, of
///     cross(corner - corner before, corner after - corner)
/// the cross product of the side that arrives at the corner and the side that
/// leaves it.
///
/// Fixed: the cross products are added as they are, not brought to unit length
/// first. So a corner on a straight side, or two corners at one place, add
/// nothing, and a reflex corner counts against the others. For a convex planar
/// face the sum points along its normal; for a quad, planar or not, along the
/// cross product of its diagonals. It is not the area vector of the face in
/// general: faces with more than four sides that are not planar get another
/// direction by that.
/// Which half-edge of the face is given does not matter.
/// Border: the zero vector when i lies on the border (its fi is -1).
/// Degenerate: the zero vector where the sum is not longer than 1e-12 times the
/// sum of the squared lengths of the sides.
/// `positions[v]` is the place of vertex v. Distance from the origin costs no
/// precision.
/// Precondition: the table is valid, 0 <= i < he.size(), there is a position
/// for every vi.
/// Cost: a constant number of reads for each side of the face.
/// Builds on: area_vector, which you may call.
/// Slide mesh, in the plane z = 0: (0, 0, 1) for half-edges 1, 4 and 8, the
/// zero vector for 0. (Lecture "mesh processing", normals of a mesh: faces that
/// are not triangles)
Vec3 polygon_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                    int i);
