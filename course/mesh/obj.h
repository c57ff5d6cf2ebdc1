// Wavefront OBJ files.
#pragma once

#include <filesystem>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// The mesh of an OBJ file: vertices, faces and loose edges (`l` lines, one
/// loose edge for each two vertices in sequence) in the order of the file, what
/// objects and groups they belong to notwithstanding. Numbers are rounded to
/// the nearest double, whatever the locale.
/// Read are v, f and l. A fourth coordinate or a colour after v, and vt, vn,
/// materials, groups, smoothing and points are passed over, but the indices of
/// f and l to vt and vn are checked. Nothing is left out, added or mended.
/// Throws MeshFileError with every defect of the file (of more than a thousand,
/// the first thousand) and its line: coordinates that are no finite numbers, or
/// not three; faces with fewer than three corners, lines with fewer than two;
/// indices that are 0, no number, or of nothing in the file; unknown keywords.
/// What only the faces together can be wrong in (edges with three faces) is
/// `build`'s to say.
/// Linear.
IndexedMesh read_obj(const std::filesystem::path& file);

/// Writes vertices, faces and loose edges, in order; read_obj gives the same
/// mesh back, to the last bit. The file appears whole or not at all.
/// Throws MeshFileError when it cannot be written, std::invalid_argument when
/// the mesh is none that a file can hold (see require_writable).
void write_obj(const std::filesystem::path& file, const IndexedMesh& mesh);

}  // namespace course
