#pragma once

#include "course/halfedge/half_edge_table.h"

/// Whether the edge of half-edge i may be collapsed. In a collapse its two ends
/// become one vertex and the edge vanishes. Each face along it loses a side; a
/// triangle along it vanishes, and its two other sides become one edge.
///
/// True when i is a half-edge of the table and all of these hold, which means
/// that the mesh is a surface afterwards, with the same holes and handles:
///  1. a vertex that is a neighbour of both ends is the third corner of a
///     triangle along the edge (the link condition)
///  2. no face has corners at both ends, but those along the edge
///  3. not both ends are on the border, unless the edge is a border edge
///  4. the one vertex will have at least three edges; at least two if an end is
///     on the border. It has those of both ends but for the edge itself, less
///     one for each triangle along the edge.
/// In a triangle mesh 2 always holds. False when i is no row of the table.
///
/// Precondition: a valid table of faces of any number of sides, whose borders
/// do not meet in a vertex; no loose edges; no two edges join the same two
/// vertices, and no face comes to a vertex twice.
/// Cost: the edges at the two ends are looked at, and the faces there, whatever
/// the size of the mesh; each as often as the other end has edges.
/// Slide mesh: can_collapse(he, 12) is true; can_collapse(he, 8) is false by
/// rule 3: the edge has a face on either side, but both ends are on the border.
/// (Lecture "mesh processing": simplification by edge collapse)
bool can_collapse(const HalfEdgeTable& he, int i);
