#pragma once

#include "course/halfedge/half_edge_table.h"
#include "exercises/02_border/boundary_loops.h"

/// How many elements of each kind a mesh has.
struct Counts {
    int vertices = 0;      ///< that some half-edge leaves
    int edges = 0;         ///< pairs of opposite half-edges, loose ones too
    int faces = 0;         ///< that some half-edge runs along
    int border_loops = 0;  ///< closed walks by `next` without a face

    friend bool operator==(const Counts&, const Counts&) = default;
};

/// The counts of the mesh, from its table.
///
/// Vertices and faces are those that occur in the table: their numbers may have
/// gaps and may be larger than the table. An isolated vertex, which no
/// half-edge leaves, does not count. A face counts once however many half-edges
/// it has. Border: a loose edge is an edge, its two ends are vertices, and the
/// border loop that passes it counts once; a loose edge that hangs on nothing
/// is a border loop of its own. A vertex that a loop, or several loops, pass
/// more than once counts once. For an empty table all counts are 0.
/// Precondition: the table is valid.
/// Cost: a fixed number of reads for each half-edge, whatever the loops are.
/// You may call boundary_loops (exercise 2.5).
/// Slide mesh: counts(he) == Counts{6, 8, 3, 1}.
/// (Lecture "modelling", notes on Euler's equation: V, L, F and B)
Counts counts(const HalfEdgeTable& he);
