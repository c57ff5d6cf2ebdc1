#pragma once

#include <stdexcept>

#include "course/mesh/indexed_mesh.h"
#include "course/mesh/soup.h"

/// The triangles of an indexed mesh as a soup: each with the coordinates of its
/// own three corners.
///
/// Fixed: triangle k is face k, and its corners come in the order of the face,
/// from the same first corner on; the coordinates are those of the vertices,
/// unchanged. Vertices that no face names, and loose edges, leave no trace.
/// A mesh without faces gives an empty soup.
/// Errors: std::invalid_argument when some face has not just three corners;
/// std::out_of_range when all faces have three, and some corner is no vertex
/// of the mesh.
/// Cost: linear in the number of faces.
/// Example: the positions (0,0,0) (1,0,0) (0,1,0) (1,1,0) and the faces
/// (0,1,2) (2,1,3) give the triangles (0,0,0) (1,0,0) (0,1,0) and
/// (0,1,0) (1,0,0) (1,1,0). (Lecture "modelling")
Soup to_soup(const IndexedMesh& mesh);
