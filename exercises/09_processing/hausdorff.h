#pragma once

#include <stdexcept>

#include "course/mesh/indexed_mesh.h"

/// How far two triangle meshes are apart: the Hausdorff distance, sampled at
/// the vertices. For each vertex of `a` that a face of `a` uses, take the
/// distance to the nearest point of the surface of `b`; for each used vertex of
/// `b` the distance to the surface of `a`; the result is the largest of all of
/// these.
///
/// The nearest point of a surface may lie inside a triangle, on an edge or at a
/// vertex. Vertices that no face uses belong to no surface and are ignored. So
/// are loose edges. A triangle without an area (corners on one line, or in one
/// point, the same vertex or not) counts as the segment or point that it is.
/// The sense of the triangles does not matter.
/// Precondition: every face has three corners, which are vertices of its mesh;
/// coordinates are finite, and sizes differ by no more than 1e6.
/// Errors: std::invalid_argument when a mesh has no face.
/// Cost: |vertices of a| * |faces of b| and the other way round will do.
/// Example: the triangle (0,0,0) (2,0,0) (0,2,0) and the same one moved by
/// (0, 0, 3) are 3 apart; moved by (4, 0, 0) instead it is 4 away: vertex
/// (6, 0, 0) from (2, 0, 0), and (0, 0, 0) from (4, 0, 0).
/// (Lecture "mesh processing": the error of simplification)
double hausdorff(const IndexedMesh& a, const IndexedMesh& b);
