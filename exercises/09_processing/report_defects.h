#pragma once

#include <array>
#include <vector>

#include "course/mesh/indexed_mesh.h"

/// What is wrong with the connectivity of a mesh. All lists are ascending, and
/// name each element once; an edge is {smaller vertex, larger vertex}.
///
/// Below, a *sound* face is one that is neither degenerate nor a duplicate. The
/// edges of a face join its corners that follow each other, the last and the
/// first as well; "the faces of an edge" are the sound faces that have it.
struct DefectReport {
    /// Faces with fewer than three corners, or with two corners at one vertex.
    std::vector<int> degenerate_faces;
    /// Faces with the corners of an earlier face that is not degenerate, in the
    /// same cyclic order: (0,1,2) and (1,2,0), but not (0,2,1). The first of
    /// them is no duplicate.
    std::vector<int> duplicate_faces;
    /// Edges with three faces or more.
    std::vector<std::array<int, 2>> non_manifold_edges;
    /// Edges with exactly two faces, which run along it in the same direction.
    std::vector<std::array<int, 2>> badly_oriented_edges;
    /// Vertices whose sound faces do not hang together there: go from face to
    /// face over edges (with any number of faces) that end at the vertex, and
    /// some of its faces are out of reach.
    std::vector<int> non_manifold_vertices;
    /// Vertices of the mesh that no sound face has for a corner.
    std::vector<int> isolated_vertices;
    /// How many pieces the border has. Its edges are those with exactly one
    /// face; two that share a vertex belong to one piece. So a hole is a piece,
    /// and the outer rim is; two loops that touch at a vertex are one piece.
    int borders = 0;
    /// How many pieces the sound faces make; two that share an edge belong to
    /// one piece, two that share only a vertex need not.
    int components = 0;

    friend bool operator==(const DefectReport&, const DefectReport&) = default;
};

/// The defects of a mesh, as a scanner may leave it: of any faces, manifold or
/// not. Positions and loose edges are not looked at.
/// Precondition: each corner of a face is a vertex of the mesh.
/// Cost: O(n log n), n the corners of all faces.
/// Example: fan3, three triangles on the edge 0-1: one non-manifold edge,
/// {0, 1}, no non-manifold vertex, one piece of border, one component.
/// (Lecture "mesh processing": mesh cleaning; lecture "modelling": 2-manifolds)
DefectReport report_defects(const IndexedMesh& mesh);
