// A mesh on which something fails, made as small as it can be while it fails.
#pragma once

#include <functional>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// What is left of the mesh, on which `fails` holds, when no face of it and no
/// vertex with its corners can be left out any more: it would not fail, or have
/// no face, or no half-edge table, or a bow-tie where the mesh has none. Loose
/// edges and vertices without a face are dropped. (Delta debugging: halves of
/// the faces first, then smaller and smaller parts) `fails` is asked at most
/// `most` times, of other meshes than the first, and what is returned is the
/// last one of which it said true; so its answers may be wrong, or change.
/// Precondition: the mesh has a table.
IndexedMesh smallest_failing(
    const IndexedMesh& mesh,
    const std::function<bool(const IndexedMesh&)>& fails, int most);

}  // namespace course
