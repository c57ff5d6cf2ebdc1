// Mesh files of any kind that is known here, told apart by their extension.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// Thrown for a file whose extension is none that can be read or written.
struct UnknownMeshFile : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The mesh of an .obj or .off file, in capitals or not. Throws UnknownMeshFile
/// for any other, else as read_obj and read_off.
IndexedMesh read_mesh(const std::filesystem::path& file);

/// Writes an .obj, .off or .ply file (binary). Throws UnknownMeshFile for any
/// other, else as write_obj, write_off and write_ply.
void write_mesh(const std::filesystem::path& file, const IndexedMesh& mesh);

}  // namespace course
