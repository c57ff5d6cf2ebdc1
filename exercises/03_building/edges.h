#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"

/// One edge of a mesh, and how many faces it has.
struct EdgeInfo {
    int a = 0, b = 0;  ///< the vertices at its ends
    int faces = 0;     ///< how many sides of faces run along it, either way

    friend bool operator==(const EdgeInfo&, const EdgeInfo&) = default;
};

/// All edges of the mesh, each once: the sides of its faces, where a side from
/// a to b and one from b to a are the same edge, and its loose edges.
///
/// `faces` counts sides: 1 on the border, 2 inside, 3 or more where the mesh is
/// no surface, 0 for a loose edge. A face that has the same edge on two of its
/// sides counts twice. How faces are wound does not matter.
/// Free: the order of the edges, and which end is a and which is b.
/// Border cases: a mesh without faces and loose edges has no edges; vertices
/// that no face uses have no part in it.
/// Precondition: each face has at least three corners, all of them vertices of
/// the mesh, and two that follow each other differ; a loose edge has two ends,
/// is no side of a face, and stands in the list once.
/// Cost: n log n for n corners, as long as few edges meet at a vertex.
/// Slide mesh: eight edges, among them {1, 2, 2} and {2, 5, 2} inside, and
/// {0, 1, 1} on the border. (Lecture "half-edge", slides 157-158 and 169)
std::vector<EdgeInfo> edges(const IndexedMesh& mesh);
