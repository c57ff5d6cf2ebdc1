// A mesh on which something fails, made as small as it can be while it fails.
#pragma once

#include <functional>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// The part of the mesh, on which `fails` holds, of which no face can be left
/// out any more: it would not fail, or have no face, or a bow-tie where the
/// mesh has none. Loose edges and vertices without a face are dropped. (Delta
/// debugging: half of the faces at a time first, then fewer and fewer.)
/// `fails` is asked at most `most` times, of other meshes than the first, and
/// what is returned is the last one of which it said true; so its answers may
/// be wrong, or change. Precondition: the mesh has a table.
IndexedMesh smallest_failing(
    const IndexedMesh& mesh,
    const std::function<bool(const IndexedMesh&)>& fails, int most);

}  // namespace course
