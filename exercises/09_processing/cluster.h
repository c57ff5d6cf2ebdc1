#pragma once

#include <stdexcept>

#include "course/mesh/indexed_mesh.h"

/// The mesh simplified by vertex clustering. Space is cut into cubes of side
/// `cell`, one of which has a corner at the origin: vertex (x, y, z) lies in
/// cube (floor(x / cell), floor(y / cell), floor(z / cell)). All vertices in a
/// cube become one, at the mean of their positions, whether or not a face uses
/// them.
///
/// Faces: each corner becomes the vertex of its cube. Where corners that follow
/// each other in a face fall together they become one (the last corner and the
/// first follow each other, too). A face that then has fewer than three
/// corners, or still comes to one vertex twice, is dropped. All others stay,
/// even if two of them have become the same: the result need be no manifold,
/// nor closed.
///
/// Fixed: faces in the order of the mesh, each with its sense. Vertices in the
/// order of the first vertex of the mesh in their cube; those that no face of
/// the result uses are left out. Free: the corner that a face begins with.
/// Loose edges are dropped.
/// Any mesh will do, open, non-manifold, or of polygons.
/// Precondition: coordinates are finite, and at most 1e15 * cell in size (so
/// that the number of a cube need not fit into int); corners are vertices of
/// the mesh.
/// Errors: std::invalid_argument unless cell is above 0 and finite.
/// Cost: O(n log n).
/// Example: the slide mesh with cell 2: vertices 0, 1 lie in cube (0, 0, 0), 2
/// in (0, -1, 0), 3 in (0, -1, 0), 4 in (1, 0, 0), 5 in (1, -1, 0). F0 is left
/// with two corners, F2 as well; F1 stays, as (0,1,3,2): its vertices are
/// (0.5, 0.5, 0), (1.25, -1.5, 0), (2, 1, 0), (2, -1, 0).
/// (Lecture "mesh processing": simplification by vertex clustering)
IndexedMesh cluster(const IndexedMesh& mesh, double cell);
