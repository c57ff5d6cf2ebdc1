#pragma once

#include <string>

#include "course/mesh/indexed_mesh.h"

/// The text of an OBJ file of the mesh: a line `v x y z` for each vertex, then
/// a line `f a b c ...` for each face, then a line `l a b` for each loose edge.
/// Vertices are numbered from 1.
///
/// Fixed: vertices, faces, corners, loose edges and their two ends in the order
/// of the mesh, vertices that no face uses included; all v lines before all f
/// lines, and these before all l lines. Corners are plain positive numbers,
/// without slashes. Who reads a coordinate back and rounds it to the nearest
/// double gets the one that the mesh has, to the last bit, the sign of -0.0
/// included. Coordinates are in decimals, perhaps with an exponent.
/// Free: how many digits a coordinate has, so long as it is that number; blanks
/// between the words, blank lines and comments (`#` to the end of the line). No
/// other statements, nothing behind the three coordinates.
/// Precondition: coordinates are finite, faces have at least three corners, and
/// these and the ends of loose edges are vertices of the mesh.
/// Cost: linear.
/// Example: for a triangle with its vertices at (0, 0, 0), (1, 0, 0) and
/// (0, 1, 0), and a loose edge from 2 to 0:
///     "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 1\n"
/// (Lecture "memory formats", page 20)
std::string write_obj(const IndexedMesh& mesh);
