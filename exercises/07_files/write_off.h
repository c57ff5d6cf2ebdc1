#pragma once

#include <stdexcept>
#include <string>

#include "course/mesh/indexed_mesh.h"

/// The text of an OFF file of the mesh: a line with the word OFF, a line with
/// three counts (of vertices, faces and edges), a line for each vertex with its
/// three coordinates, a line for each face with the number of its corners and
/// the corners, vertices counted from 0.
///
/// Fixed: vertices, faces and corners in the order of the mesh, vertices that
/// no face uses included. Who reads a coordinate back and rounds it to the
/// nearest double gets the one that the mesh has, to the last bit, the sign of
/// -0.0 included. Coordinates are in decimals, perhaps with an exponent.
/// Free: how many digits a coordinate has, so long as it is that number; the
/// third count, any number from 0; blanks between the words, blank lines and
/// comments (`#` to the end of the line). No colours, no other words.
/// Precondition: coordinates are finite, faces have at least three corners,
/// and these are vertices of the mesh.
/// Errors: std::invalid_argument when the mesh has loose edges, since OFF has
/// no form for them, and they would be lost without a word.
/// Cost: linear.
/// Example: for a triangle with its vertices at (0, 0, 0),
/// (1, 0, 0) and (0, 1, 0):
///     "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
/// (Lecture "modelling")
std::string write_off(const IndexedMesh& mesh);
