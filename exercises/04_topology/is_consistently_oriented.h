#pragma once

#include "course/mesh/indexed_mesh.h"

/// Whether neighbouring faces are wound compatibly: wherever two faces share an
/// edge, one runs along it from a to b, and the other from b to a. In other
/// words: no two sides of faces run from the same vertex to the same vertex.
///
/// Only faces that share an edge are compared; those that share a vertex and no
/// edge, or nothing, are always compatible, so that a part may be turned over
/// as a whole. Of three faces at one edge two always run along it alike: false.
/// The face may be begun at any corner, that changes nothing. Positions, loose
/// edges and unused vertices do not matter. A mesh without faces: true.
/// Precondition: each face has at least three corners, at different vertices of
/// the mesh.
/// Cost: n log n for n corners.
/// Slide mesh: true. With face (1,2,5,4) turned over to (4,5,2,1): false.
/// (Lecture "modelling", notes on orientable meshes; lecture "mesh memory
/// formats", page 6; lecture "half-edge", slide 170)
bool is_consistently_oriented(const IndexedMesh& mesh);
