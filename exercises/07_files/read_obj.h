#pragma once

#include <stdexcept>
#include <string>

#include "course/mesh/indexed_mesh.h"

/// The mesh that the text of an OBJ file describes. Each line is one statement
/// and begins with its keyword:
///   v x y z       a vertex; numbers behind these three (a fourth coordinate,
///                 a colour) are ignored
///   f a b c ...   a face of at least three corners
///   l a b ...     a line: a loose edge from a to b, from b to the next, ...
///   vt vn vp p g o s usemtl mtllib   passed over, with all that follows
/// A corner of f or l is the number of a vertex: from 1, in the order of the
/// v lines of the whole file, be they before the corner or after it; or from
/// -1, the last v line above this line, downwards: -2 is the one before that.
/// What follows the number after a slash, as in 7/2, 7//3 and 7/2/3, says
/// nothing about the mesh and is ignored.
///
/// Fixed: order of vertices, faces, corners and loose edges as in the text,
/// whatever groups and objects they are in; coordinates the nearest double;
/// vertices counted from 0 in the mesh. What nothing names stays.
/// The text: lines end in \n or \r\n, the last one perhaps in nothing. `#` and
/// what follows it on the line is a comment; lines with nothing else than
/// blanks (spaces, tabs) and a comment do not matter. No text at all is an
/// empty mesh.
/// Errors: std::runtime_error (itself, no class derived from it). Its message
/// begins with "line N: ", where N is the line of the first defect, from 1;
/// every line of the text counts. Defects are
/// - a keyword that is not in the list above;
/// - a vertex with fewer than three numbers, one of these three that is not a
///   number as a whole (abc, 1.5x), or not finite (nan, inf, 1e999);
/// - a face with fewer than three corners, a line with fewer than two;
/// - a corner that is not, up to its first slash, a whole number (x, 1.5, /2,
///   2x/1), that is 0, or that names no vertex: above the number of v lines of
///   the file, or further back than the first.
/// A face that comes to a vertex twice is none: it is for others to judge.
/// Free: what becomes of words that are no numbers behind x y z or behind a
/// slash, of more than two slashes, of whole numbers beyond the range of int,
/// of a + before a number, of hexadecimal numbers, of numbers nearer to 0 than
/// 1e-300, and of `\` at the end of a line.
/// Cost: linear in the length of the text.
/// Example: read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -1\n") is a triangle
/// (0, 1, 2); with `f 1 2 4` at the end, the message begins with "line 4: ".
/// (Lecture "memory formats", page 20)
IndexedMesh read_obj(const std::string& text);
