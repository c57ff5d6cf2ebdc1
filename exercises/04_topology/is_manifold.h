#pragma once

#include "course/mesh/indexed_mesh.h"

/// Whether the faces form a 2-manifold, with a border or without: a surface
/// that looks everywhere like a piece of plane. That is so when
///  - each edge is a side of one face or of two, and
///  - the faces at each vertex form one fan, open or closed: from any one of
///    them one can come to any other one, going from face to face across edges
///    that end at this vertex.
///
/// How the faces are wound does not matter, nor whether they can be wound
/// consistently: a Moebius band is a manifold. Two faces may share several
/// edges, or have the same corners. Vertices that no face uses are ignored, and
/// so are loose edges and positions. A mesh without faces: true.
/// Precondition: each face has at least three corners, at different vertices of
/// the mesh.
/// Cost: n log n for n corners, even if all faces meet at one vertex.
/// Slide mesh: true. Two triangles with only one vertex in common (0,1,2)
/// (0,3,4), or three at one edge (0,1,2) (1,0,3) (0,1,4): false.
/// (Lecture "modelling", the 2-manifold condition; lecture "mesh memory
/// formats", page 5)
bool is_manifold(const IndexedMesh& mesh);
