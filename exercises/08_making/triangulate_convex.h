#pragma once

#include <stdexcept>

#include "course/mesh/indexed_mesh.h"

/// The mesh with each face cut into triangles: a fan from its first corner. The
/// face (a, b, c, d, e) becomes (a, b, c), (a, c, d), (a, d, e); a face of n
/// corners becomes n - 2 triangles, and a triangle stays one.
///
/// Fixed: the triangles of face 0 come first, in the order of the fan, then
/// those of face 1, and so on. Each is wound as its face is. Positions and
/// loose edges stay as they are.
/// Free: the corner with which a triangle begins: (a, c, d) may be (c, d, a).
/// A fan is right for convex faces; others are cut in the same way, and may
/// come out folded. Positions are not needed for it.
/// Precondition: the corners of the faces are vertices of the mesh.
/// Errors: std::invalid_argument when a face has fewer than three corners.
/// Cost: linear in the number of corners.
/// Slide mesh: (0,2,1), (1,2,5,4), (2,3,5) becomes (0,2,1), (1,2,5), (1,5,4),
/// (2,3,5). (Lecture "modelling")
IndexedMesh triangulate_convex(const IndexedMesh& mesh);
