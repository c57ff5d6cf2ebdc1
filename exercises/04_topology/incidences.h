#pragma once

#include "course/halfedge/half_edge_table.h"

/// How often the elements of a mesh meet, two kinds at a time: how many entries
/// all lists of the one at the other have together.
struct Incidences {
    int edge_face = 0;    ///< an edge and a face beside it
    int vertex_face = 0;  ///< a vertex and a face with a corner at it
    int edge_vertex = 0;  ///< an edge and a vertex at its end

    friend bool operator==(const Incidences&, const Incidences&) = default;
};

/// The incidences of the mesh.
///
/// Every meeting counts: a face that lies on both sides of an edge meets it
/// twice, and a face that comes to a vertex with two corners meets it twice. An
/// edge meets the two vertices at its ends, even if it is a loose edge; a loose
/// edge meets no face. None of the three numbers is larger than twice the
/// number of edges. For an empty table all are 0. Numbers of vertices and faces
/// may have gaps. Precondition: the table is valid. Cost: a fixed number of
/// reads for each half-edge. Slide mesh: incidences(he) == Incidences{10, 10,
/// 16}. (Lecture "mesh memory formats", page 13)
Incidences incidences(const HalfEdgeTable& he);
