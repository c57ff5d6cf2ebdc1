// The border as it is found in the face list, and where to ask for it.
#pragma once

#include <vector>

#include "course/runner/border_by_faces.h"

namespace course::oracle {

/// All half-edges of a small table, a hundred of a larger one.
std::vector<int> sample(const HalfEdgeTable& he);

/// The half-edges whose row names no face: for a mesh that is too large to be
/// searched by brute force.
std::vector<int> border_rows(const HalfEdgeTable& he);

}  // namespace course::oracle
