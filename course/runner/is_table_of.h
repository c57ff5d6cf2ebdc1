// A matcher for exercises whose answer is a half-edge table: numbered in any
// way, it must be valid and hold the faces of a mesh.
#pragma once

#include <string>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"
#include "course/runner/print.h"

namespace course {

/// Why `he` is no half-edge table of `mesh`, or "": a rule that it breaks, or a
/// face or loose edge that it has and the mesh has not, or the other way round.
/// Half-edges may have any numbers, faces and vertices have those of the mesh;
/// where borders meet at a vertex, any legal linking is right. Any numbers may
/// stand in `he`. Cost O(n log n).
std::string difference(const HalfEdgeTable& he, const IndexedMesh& mesh);

class TableMatcher : public CatchMatcherBase<HalfEdgeTable> {
public:
    explicit TableMatcher(IndexedMesh mesh) : mesh_(std::move(mesh)) {}

    bool match(const HalfEdgeTable& got) const override {
        why_ = difference(got, mesh_);
        return why_.empty();
    }
    std::string describe() const override {
        return "is a half-edge table of these faces: " + show(mesh_.faces) +
               (why_.empty() ? "" : "\n" + why_);
    }

private:
    IndexedMesh mesh_;
    mutable std::string why_;
};

}  // namespace course

/// A half-edge table of the mesh, see course::difference.
course::TableMatcher IsTableOf(IndexedMesh mesh);
