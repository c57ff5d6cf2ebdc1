// What is measured, and of whom: the course's table and the libraries that do
// the same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace bench {

/// The walks over a whole mesh, the last one back to lists of corners. Each
/// returns a sum that is the same whoever walks.
enum class Walk {
    stars,
    faces,
    adjacent_faces,
    border_loops,
    vertex_normals,
    back_to_faces
};

/// A mesh in the structure of one library, ready for walks.
class Built {
public:
    Built() = default;
    Built(const Built&) = delete;
    Built& operator=(const Built&) = delete;
    virtual ~Built() = default;
    virtual double sum(Walk walk) const = 0;
};

/// A library. What it has no function for is null.
struct Peer {
    using Read = void (*)(const std::filesystem::path&);

    const char* name;
    std::unique_ptr<Built> (*build)(const IndexedMesh&) = nullptr;
    void (*table)(const IndexedMesh&) = nullptr;  ///< half-edges alone
    Read read_obj = nullptr;   ///< into the library's own structure
    Read read_off = nullptr;   ///< the same
    Read obj_faces = nullptr;  ///< into lists of faces only
    Read off_faces = nullptr;  ///< the same
};

Peer course_peer();
Peer bytes_peer();  ///< no library: the same bytes read and written once
Peer tinyobj_peer();
Peer cgal_peer();
Peer openmesh_peer();

/// The course's own first; then those that the machine has.
std::vector<Peer> peers();

/// Keeps the compiler from leaving out what nobody looks at.
void keep(const void* made);

}  // namespace bench
