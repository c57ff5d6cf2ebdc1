#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "exercises/06_geometry/area_vector.h"

/// The normals of all vertices of an indexed mesh, by area: result[v] is the
/// unit vector in the direction of the sum of the area vectors of the faces at
/// vertex v. The linear algorithm of the lecture: no half-edges, only the list
/// of faces.
///
/// A face adds its area vector once for each of its corners at v. The area
/// vector of a face p0, p1, ..., pn is the sum of those of the triangles round
/// one of its corners,
///     area_vector(p0, p1, p2) + area_vector(p0, p2, p3) + ...
/// which is the same from every corner, and twice the area of a planar face,
/// also of one that is not convex. On a mesh of triangles, result[v] is what
/// vertex_normal finds with Weight::area.
/// Shape: one vector for each vertex of the mesh, also for those that no face
/// uses: they get the zero vector. `loose_edges` mean nothing.
/// Degenerate: the zero vector where the sum is not longer than 1e-12 times the
/// sum of the squared lengths of all sides of those faces, a face again counted
/// once for each of its corners at v: so where normals cancel out, and where
/// all faces are degenerate.
/// Precision: neither the unit of length nor the distance from the origin
/// matters.
/// Precondition: every face has at least three corners, each 0 <= v <
/// vertex_count(). The mesh need not be manifold, nor well oriented (though
/// only then its normals point to one side).
/// Cost: linear in the corners of all faces.
/// Builds on: area_vector, which you may call.
/// Slide mesh: six times (0, 0, 1). (Lecture "mesh processing", the question at
/// the end of normals per vertex)
std::vector<Vec3> vertex_normals(const IndexedMesh& mesh);
