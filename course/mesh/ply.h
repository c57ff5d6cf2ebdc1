// PLY files, which other programs read: only written here.
#pragma once

#include <filesystem>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// How the numbers stand in a PLY file.
enum class PlyFormat { ascii, binary };

/// Writes vertices (as double), faces and loose edges (as element `edge`), in
/// order; binary is little endian, on any machine. Who reads decimals to the
/// nearest double gets the positions back to the last bit. The number of sides
/// is a uchar, which every program takes, unless a face has more than 255. The
/// file appears whole or not at all. Linear.
/// Throws MeshFileError when it cannot be written, std::invalid_argument when
/// the mesh is none that a file can hold (see require_writable).
/// (Turk, "The PLY polygon file format", 1994)
void write_ply(const std::filesystem::path& file, const IndexedMesh& mesh,
               PlyFormat format = PlyFormat::binary);

}  // namespace course
