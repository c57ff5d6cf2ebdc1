// Cleaning: any faces at all have a half-edge table afterwards.
#include "course/mesh/clean.h"

#include "grader/fuzz/mesh_fuzz.h"

namespace {

/// Each byte is a corner, from -2 on; those from 200 on end a face, and the
/// last few corners are loose edges.
IndexedMesh mesh_of(const std::uint8_t* data, std::size_t size) {
    IndexedMesh mesh;
    if (size == 0) return mesh;
    mesh.positions.resize(data[0]);
    std::vector<int> corners;
    for (std::size_t k = 1; k < size; ++k) {
        if (data[k] < 200) {
            corners.push_back(data[k] - 2);
            continue;
        }
        mesh.faces.push_back(corners);
        corners.clear();
    }
    for (std::size_t k = 1; k < corners.size(); k += 2)
        mesh.loose_edges.push_back({corners[k - 1], corners[k]});
    return mesh;
}

void check_clean(const IndexedMesh& mesh, const course::CleanOptions& options) {
    const course::Cleaned cleaned = course::clean(mesh, options);
    fuzz::require(course::defects(cleaned.mesh).empty(),
                  "a cleaned mesh has no defects");
    fuzz::require(course::bow_tie_vertices(cleaned.mesh).empty(),
                  "a cleaned mesh has no bow-ties");
    fuzz::check_build(cleaned.mesh);
    fuzz::require(course::clean(cleaned.mesh, options).changes.empty(),
                  "a cleaned mesh is clean");
    for (const course::Change& change : cleaned.changes)
        fuzz::require(!to_string(change).empty(), "a change has a text");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const IndexedMesh mesh = mesh_of(data, size);
    check_clean(mesh, {});
    check_clean(mesh, {.most_sides = 100, .drop_unused = true});
    return 0;
}
