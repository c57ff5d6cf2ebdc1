#pragma once

#include <stdexcept>
#include <string>

#include "course/mesh/indexed_mesh.h"

/// The mesh that the text of an OFF file describes: the word OFF, three counts
/// (of vertices, faces and edges), a line for each vertex with its three
/// coordinates, a line for each face with the number of its corners and the
/// corners, vertices counted from 0.
///
/// Fixed: order of vertices, faces and corners as in the text, coordinates the
/// nearest double, no loose edges. Vertices that no face uses stay.
/// The text: lines end in \n or \r\n, the last one perhaps in nothing. `#` and
/// what follows it on the line is a comment; lines with nothing else than
/// blanks (spaces, tabs) and a comment do not matter, wherever they stand. The
/// counts stand on a line of their own, or behind OFF on its line. The third
/// count is not compared with anything. Up to four numbers behind the corners
/// of a face are its colour, and ignored.
/// Errors: std::runtime_error (itself, no class derived from it). Its message
/// begins with "line N: ", where N is the line of the first defect, from 1;
/// every line of the text counts. Defects are
/// - a first word that is not OFF; not exactly three counts; a count that is
///   negative, or not a whole number;
/// - a vertex with fewer or more than three numbers, a coordinate that is not a
///   number as a whole (abc, 1.5x), or not finite (nan, inf, 1e999);
/// - a number of corners below 3 or not whole; fewer corners than it says; a
///   corner that is not a whole number, or names no vertex;
/// - anything that is no comment after the last face;
/// - a text that ends too early. N may then be any line from the last one with
///   something on it up to the first one that is not there any more.
/// A face that comes to a vertex twice is none: it is for others to judge.
/// Free: what becomes of words behind the corners of a face that are no colour,
/// of whole numbers beyond the range of int, of a + before a number, of
/// hexadecimal numbers, and of numbers nearer to 0 than 1e-300.
/// Cost: linear in the length of the text. A count is a promise, and may be a
/// lie: memory only for what is really there.
/// Example: read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") is a
/// triangle; with `3 0 1 3` at the end, the message begins with "line 6: ".
/// (Lecture "modelling")
IndexedMesh read_off(const std::string& text);
