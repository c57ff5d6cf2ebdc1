// What the pictures ask of faces and tables, by a plain search.
#pragma once

#include <array>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// The sides of a face, {from, to} each, as the face runs.
std::vector<std::array<int, 2>> sides_of(FaceList::Face corners);

/// Whether the face runs from a straight to b.
bool has_side(FaceList::Face corners, int a, int b);

/// The first half-edge that leaves vertex v. Not counted as reads.
/// Precondition: there is one.
int leaving(const HalfEdgeTable& he, int v);

}  // namespace course
