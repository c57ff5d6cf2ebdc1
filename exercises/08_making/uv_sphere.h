#pragma once

#include <stdexcept>

#include "course/mesh/indexed_mesh.h"

/// The unit sphere round the origin as a mesh of triangles, from a grid of nu
/// meridians and nv bands: what becomes of a quadric on its way to triangles.
///
/// Vertices: the two poles (0, 0, 1) and (0, 0, -1), once each; and the
/// crossings of the meridians with the nv - 1 circles between the bands, once
/// each. Meridian i < nu meets circle j, 0 < j < nv, in
///   (sin a cos b, sin a sin b, cos a), a = pi j / nv, b = 2 pi i / nu,
/// so that meridian 0 runs through (1, 0, 0). V = 2 + nu (nv - 1).
/// Faces: one triangle for each cell of the two bands at the poles, two for
/// each other cell, cut along one of its diagonals. F = 2 nu (nv - 1). The mesh
/// is closed, and wound outwards: counter-clockwise seen from outside.
///
/// Free: the numbers of the vertices, the order of the triangles, where each
/// begins, and along which diagonal each cell is cut. Loose edges: none.
/// Errors: std::invalid_argument when nu is below 3 or nv below 2.
/// Cost: linear in the number of vertices.
/// Example: uv_sphere(4, 2) is the octahedron with the vertices (1,0,0),
/// (0,1,0), (-1,0,0), (0,-1,0) and the poles; 8 triangles.
/// (Lecture "modelling")
IndexedMesh uv_sphere(int nu, int nv);
