#pragma once

#include <vector>

#include "course/mesh/winged.h"

/// The faces at vertex v of a winged-edge mesh, each once, in any order.
///
/// They are those that the walk round v meets: from the edge mesh.vertex[v] on,
/// from edge to edge at v, each time to the next one round the vertex, until it
/// is back. The walk goes on along the border, where there is no face to list.
/// At a bow-tie (faces that share only this vertex), what such a walk does not
/// meet is not listed.
/// Border: -1 is never in the list. At a vertex that has only loose edges: an
/// empty list.
/// Isolated vertex (mesh.vertex[v] is -1): an empty list.
/// Precondition: `mesh` is the winged-edge structure of some half-edge table,
/// as course/mesh/winged.h describes it, with edges numbered and directed in
/// any way; 0 <= v < mesh.vertex.size(). Faces may have any number of sides.
/// Cost: depends on the edges at v, not on the size of the mesh.
/// Slide mesh: winged_faces(mesh, 2) is {0, 1, 2}, and winged_faces(mesh, 0) is
/// {0}, in any order. (Lecture "modelling", the first of its exercises)
std::vector<int> winged_faces(const WingedMesh& mesh, int v);
