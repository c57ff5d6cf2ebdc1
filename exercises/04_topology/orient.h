#pragma once

#include <optional>
#include <vector>

#include "course/mesh/indexed_mesh.h"

/// Which faces to turn over, so that neighbours are wound compatibly: flags by
/// face, true for those whose corners must be reversed. Afterwards the mesh is
/// as is_consistently_oriented (exercise 4.6) asks for: no two sides of faces
/// run from the same vertex to the same vertex. std::nullopt when no choice of
/// faces brings that about.
///
/// Free: in each part of the mesh (faces joined by common edges) the flags may
/// come out all opposite, as the part may be turned over as a whole; any right
/// choice will do, also where the mesh was consistent already.
/// Border cases: faces that have only a vertex in common need not agree. Of
/// three faces at one edge two run along it alike, however they are turned: no
/// choice. Two faces may share several edges, and must agree at all of them. A
/// mesh without faces has an empty list of flags, which is not std::nullopt.
/// Positions, loose edges and unused vertices do not matter.
/// Precondition: each face has at least three corners, at different vertices of
/// the mesh.
/// Cost: n log n for n corners.
/// Slide mesh: {false, false, false}, or {true, true, true}. With its quad
/// turned over: {false, true, false}, or {true, false, true}. A Moebius band:
/// std::nullopt. (Lecture "modelling", notes on orientable meshes; lecture
/// "mesh memory formats", page 6)
std::optional<std::vector<bool>> orient(const IndexedMesh& mesh);
