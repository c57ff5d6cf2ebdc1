// What is asked of every reader of mesh files, and of what takes its meshes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/file_defects.h"
#include "course/runner/temporary_folder.h"
#include "grader/fuzz/fuzz.h"

namespace fuzz {

using ReadMesh = IndexedMesh (*)(const std::filesystem::path&);
using WriteMesh = void (*)(const std::filesystem::path&, const IndexedMesh&);

inline bool is_finite(const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline void check_mesh(const IndexedMesh& mesh) {
    const auto is_vertex = [&](int v) {
        return v >= 0 && v < mesh.vertex_count();
    };
    require(
        std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite),
        "positions are finite");
    for (const FaceList::Face face : mesh.faces) {
        require(face.size() >= 3, "faces have three corners");
        require(std::all_of(face.begin(), face.end(), is_vertex),
                "the corners of faces are vertices");
    }
    for (const auto& [a, b] : mesh.loose_edges)
        require(is_vertex(a) && is_vertex(b), "loose edges join vertices");
}

/// Not as numbers: 0 and -0 are two.
inline bool same_bits(const Vec3& a, const Vec3& b) {
    return std::bit_cast<std::array<std::uint64_t, 3>>(a) ==
           std::bit_cast<std::array<std::uint64_t, 3>>(b);
}

inline void check_same(const IndexedMesh& a, const IndexedMesh& b) {
    require(a.faces == b.faces && a.loose_edges == b.loose_edges,
            "faces and loose edges come back");
    require(std::equal(a.positions.begin(), a.positions.end(),
                       b.positions.begin(), b.positions.end(), same_bits),
            "positions come back to the last bit");
}

/// A table without a fault and with the faces of the mesh, or all defects.
inline void check_build(const IndexedMesh& mesh) {
    try {
        const HalfEdgeTable he = course::build(mesh);
        require(course::validate(he).empty(), "build makes sound tables");
        require(course::to_faces(he).size() == mesh.faces.size(),
                "build leaves no face out");
    } catch (const course::BuildError& error) {
        require(!error.defects().empty(), "build says what is wrong");
    }
}

inline void check_reader(ReadMesh read, WriteMesh write,
                         std::string_view bytes) {
    static const InputFile input;
    static const course::TemporaryFolder folder;
    IndexedMesh mesh;
    try {
        mesh = read(input.with(bytes));
    } catch (const course::MeshFileError& error) {
        require(!error.defects().empty(), "a refused file has a defect");
        return;
    }
    check_mesh(mesh);
    write(folder / "mesh", mesh);
    check_same(mesh, read(folder / "mesh"));
    check_build(mesh);
}

}  // namespace fuzz
