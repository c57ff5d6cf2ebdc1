// Faces of a mesh that share an edge, also where there is no half-edge table.
#pragma once

#include <vector>

#include "course/halfedge/edge_uses.h"

namespace course {

/// Sides of faces are numbered as the corners from which they start, in
/// faces.corners(). Precondition: the mesh outlives it.
class Neighbours {
public:
    /// O(n log n) for n corners. Throws std::length_error as edge_uses.
    explicit Neighbours(const IndexedMesh& mesh)
        : mesh_(mesh), uses_(edge_uses(mesh)) {
        const std::size_t sides = mesh.faces.corners().size();
        face_.reserve(sides);
        for (int f = 0; f < mesh.faces.size(); ++f)
            face_.insert(face_.end(), mesh.faces[f].size(), f);
        across_.assign(sides, -1);
        for_each_edge(uses_, [&](const EdgeUse* use, const EdgeUse* end) {
            if (end - use != 2) return;
            across_[at(use[0].corner)] = use[1].corner;
            across_[at(use[1].corner)] = use[0].corner;
        });
    }

    const std::vector<EdgeUse>& uses() const { return uses_; }
    int face(int side) const { return face_[at(side)]; }
    int start(int side) const { return mesh_.faces.corners()[at(side)]; }
    int tip(int side) const { return start(next(side)); }
    /// The side of the other face, where the edge has just two; else -1.
    int across(int side) const { return across_[at(side)]; }
    /// Whether the face across runs along the edge in the same direction.
    bool is_alike(int side) const { return start(side) == start(across(side)); }
    /// The sides after and before it, round the face.
    int next(int side) const {
        return side + 1 < end_of_face(side) ? side + 1 : first(face(side));
    }
    int previous(int side) const {
        return side > first(face(side)) ? side - 1 : end_of_face(side) - 1;
    }
    int first(int face) const {
        return static_cast<int>(mesh_.faces[face].data() -
                                mesh_.faces.corners().data());
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    int end_of_face(int side) const {
        const int f = face(side);
        return first(f) + static_cast<int>(mesh_.faces[f].size());
    }

    const IndexedMesh& mesh_;
    std::vector<EdgeUse> uses_;
    std::vector<int> face_;
    std::vector<int> across_;
};

}  // namespace course
