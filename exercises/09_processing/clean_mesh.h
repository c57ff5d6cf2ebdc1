#pragma once

#include "course/mesh/indexed_mesh.h"

/// The mesh without the faces and vertices that mean nothing. In this order:
///
/// 1. In each face, corners that follow each other and are the same vertex
///    become one corner; the last and the first follow each other, too.
/// 2. Faces that now have fewer than three corners, or that still come to one
///    vertex twice, are dropped.
/// 3. Of faces that now have the same corners in the same cyclic order only the
///    first stays. (0,1,2) and (1,2,0) are the same, (0,2,1) is another.
/// 4. Vertices that no face uses any more are left out.
///
/// All else stays, even where the mesh is no manifold or badly oriented.
/// Fixed: the faces keep their order and their sense, the vertices their order
/// and exactly their positions. Free: the corner that a face begins with.
/// Loose edges are dropped. Two vertices at one position are two vertices.
/// Precondition: corners are vertices of the mesh.
/// Cost: O(n log n), n the corners of all faces and the vertices.
/// Example: of the faces (3,1,1,2) (2,2,1) (1,2,3) (4,1,2) on the vertices 0..4
/// the first and the last stay, as (2,0,1) and (3,0,1): vertex 0 goes.
/// (Lecture "mesh processing": mesh cleaning)
IndexedMesh clean_mesh(const IndexedMesh& mesh);
