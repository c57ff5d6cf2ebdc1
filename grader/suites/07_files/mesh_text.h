// Meshes as texts for the suites of the file exercises: writers of their own,
// strict readers of what a submission wrote, and damage to texts. Nothing here
// uses the readers and writers of course/mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "course/mesh/zoo.h"

namespace course::hidden {

/// The lines of a text, without their ends.
using TextLines = std::vector<std::string>;

/// An OFF file of the mesh, without its loose edges: line 0 is OFF, line 1 the
/// counts, then a line for each vertex and each face.
TextLines off_lines(const IndexedMesh& mesh);

/// An OBJ file: v lines, f lines with indices from 1, and an l line for each
/// loose edge.
TextLines obj_lines(const IndexedMesh& mesh);

/// Each line with this end.
std::string joined(const TextLines& lines, const std::string& end = "\n");

/// A text with what does not matter between and behind its lines.
struct Decorated {
    std::string text;
    std::vector<int> number;  ///< of each line that was given, from 1
};

/// Comments, blank lines, tabs and other line ends, by chance from `salt`.
Decorated decorated(const TextLines& lines, std::uint64_t salt);

/// What a submission wrote, as a mesh; or why it cannot be taken for one.
struct ReadBack {
    IndexedMesh mesh;
    std::string wrong;
};
ReadBack off_read_back(const std::string& text);
ReadBack obj_read_back(const std::string& text);

/// The first thing in which the meshes differ, to the last bit, or "".
std::string mesh_difference(const IndexedMesh& got, const IndexedMesh& wanted);

/// The line N of a message that begins with "line N: "; -1 of another one.
int named_line(const std::string& message);

/// The same mesh with coordinates of all sizes, that need all their digits.
IndexedMesh with_awkward_positions(IndexedMesh mesh, std::uint64_t salt);

/// Meshes with and without loose edges, also ones that have no half-edge table.
std::vector<Fixture> file_meshes();

/// The same without loose edges.
std::vector<Fixture> without_loose_edges(std::vector<Fixture> fixtures);

/// Faces of n sides, one for each number of `sides`, side by side.
Fixture polygons(const std::vector<int>& sides);

}  // namespace course::hidden
