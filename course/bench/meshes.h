// The meshes that are measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace bench {

struct Case {
    std::string name;
    IndexedMesh mesh;
};

/// The same mesh with vertices and faces in random order.
IndexedMesh shuffled(const IndexedMesh& mesh);

/// A million triangles in order and shuffled, a million quads, four million
/// triangles; hundred times less of each when `quick`.
std::vector<std::string> made_meshes();
Case made_mesh(const std::string& name, bool quick);

/// An OBJ or OFF file, by its ending.
Case mesh_of_file(const std::filesystem::path& file);

}  // namespace bench
