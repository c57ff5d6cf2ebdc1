// The defects of a mesh, by comparing everything with everything; and meshes
// that have many of them.
#pragma once

#include <cstdint>
#include <vector>

#include "course/mesh/zoo.h"
#include "exercises/09_processing/report_defects.h"

namespace course::oracle {

/// As the exercise defines it. Quadratic.
DefectReport all_defects(const IndexedMesh& mesh);

}  // namespace course::oracle

namespace course::hidden {

/// A random mesh as a careless scanner might leave it: faces flipped, there
/// twice, degenerate; fins on edges; vertices that fell together or that no
/// face uses. From the seed of the run and `salt`.
Fixture dirty_scan(std::uint64_t salt);

}  // namespace course::hidden
