// OFF files. (Lecture "modelling")
#pragma once

#include <filesystem>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// The mesh of an OFF file: `OFF`, three counts (vertices, faces, and edges,
/// which is not checked), then a line per vertex and a line per face: the
/// number of corners, and the corners from 0. `#` starts a comment, blank lines
/// and the kind of line ends do not matter, the counts may follow `OFF` on its
/// line. A colour after a face, of up to four numbers, is passed over.
/// Throws MeshFileError with every defect of the file (of more than a thousand,
/// the first thousand) and its line: coordinates that are no finite numbers, or
/// not three; faces with fewer than three corners; indices that are no vertex;
/// fewer lines than the counts say, and anything after the last face.
/// Linear.
IndexedMesh read_off(const std::filesystem::path& file);

/// Writes vertices and faces, in order; read_off gives the same mesh back, to
/// the last bit. The file appears whole or not at all. The count of edges is
/// written as 0, as is usual.
/// Throws MeshFileError when it cannot be written, std::invalid_argument when
/// the mesh is none that a file can hold (see require_writable), or has loose
/// edges, for which OFF has no form.
void write_off(const std::filesystem::path& file, const IndexedMesh& mesh);

}  // namespace course
