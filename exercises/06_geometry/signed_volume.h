#pragma once

#include "course/mesh/indexed_mesh.h"

/// The volume that a closed mesh encloses: positive when its faces are wound
/// counter-clockwise as seen from outside, negative when it is inside out.
///
/// Fixed: a face with more than three corners counts as the triangles round its
/// first corner, (p0, p1, p2), (p0, p2, p3), and so on. For a planar face any
/// other cut has the same volume, for a bent one it has not.
/// Parts that are apart from each other are added up, each with its own sign: a
/// hollow, wound the other way round, is taken off. Vertices that no face uses
/// and `loose_edges` mean nothing, wherever they are. 0 for a mesh without
/// faces, which may have no vertices either.
/// Precision: that of double, relative to the size of the mesh and not to its
/// distance from the origin. A small mesh far away must be as exact as one at
/// the origin.
/// Precondition: the mesh is closed and consistently oriented; every face has
/// at least three corners, each 0 <= v < vertex_count().
/// Cost: linear in the corners of all faces.
/// Example: the lecture's tetrahedron, zoo mesh "tetra", has the volume -8/3:
/// it is inside out. (Lecture "modelling", orientation and the OFF example)
double signed_volume(const IndexedMesh& mesh);
