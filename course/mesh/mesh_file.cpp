// Mesh files by extension.
#include "course/mesh/mesh_file.h"

#include <fmt/format.h>

#include <string>

#include "course/mesh/ascii.h"
#include "course/mesh/obj.h"
#include "course/mesh/off.h"
#include "course/mesh/ply.h"

namespace course {

namespace {

std::string kind_of(const std::filesystem::path& file) {
    return ascii_lower(file.extension().string());
}

[[noreturn]] void refuse(const std::filesystem::path& file,
                         const char* expected) {
    throw UnknownMeshFile(fmt::format("{}: the extension is `{}`, expected {}",
                                      file.string(), file.extension().string(),
                                      expected));
}

}  // namespace

IndexedMesh read_mesh(const std::filesystem::path& file) {
    const std::string kind = kind_of(file);
    if (kind == ".obj") return read_obj(file);
    if (kind == ".off") return read_off(file);
    refuse(file, ".obj or .off");
}

void write_mesh(const std::filesystem::path& file, const IndexedMesh& mesh) {
    const std::string kind = kind_of(file);
    if (kind == ".off")
        write_off(file, mesh);
    else if (kind == ".ply")
        write_ply(file, mesh);
    else if (kind == ".obj")
        write_obj(file, mesh);
    else
        refuse(file, ".obj, .off or .ply");
}

}  // namespace course
