#pragma once

#include "exercises/04_topology/counts.h"

/// How many integers (indices or pointers) the connectivity of a mesh takes in
/// each of the lecture's data structures. Positions, and the lengths of lists,
/// are left out.
struct Storage {
    /// Face list: one vertex for each corner of each face.
    int face_list = 0;
    /// Half-edge table: vi, fi, next and opp of each half-edge, border ones
    /// too.
    int half_edges = 0;
    /// The same with anchors: one half-edge for each vertex and for each face.
    int half_edges_with_anchors = 0;
    /// Winged edge: of each edge its two vertices, its two faces (or their
    /// absence) and four edges that follow it; one edge for each vertex and for
    /// each face.
    int winged_edges = 0;
    /// Adjacency lists: at each vertex its faces and its edges, at each edge
    /// its two vertices and its faces, at each face its vertices and its edges.
    int adjacency_lists = 0;

    friend bool operator==(const Storage&, const Storage&) = default;
};

/// What a mesh with these counts takes. `corners` is the number of sides of all
/// faces together: 4 for each quad, 3 for each triangle.
///
/// In the adjacency lists every meeting has an entry: a face with two corners
/// at a vertex stands there twice. Loose edges are edges; they have no face.
/// Border loops take nothing of their own. All of `n` may be 0, together.
/// Precondition: the numbers are those of a mesh, and the results fit into int.
/// Cost: constant.
/// Slide mesh, V, E, F = 6, 8, 3 and 10 corners:
///     storage(Counts{6, 8, 3, 1}, 10) == Storage{10, 64, 73, 73, 72}.
/// (Lecture "half-edge", slides 166-170 and 182; lecture "modelling", winged
/// edge; lecture "mesh memory formats", pages 11-13)
Storage storage(const Counts& n, int corners);
