// What boundary_walk and boundary_walk_bug are tested for: they have the same
// contract, so their suites share the checks.
#pragma once

#include <vector>

#include "course/mesh/zoo.h"

namespace course::walk_checks {

/// The function under test.
using Walk = std::vector<int> (*)(const HalfEdgeTable&, int);

void from_the_border(Walk boundary_walk, const Fixture& fixture);
void from_beside_the_border(Walk boundary_walk, const Fixture& fixture);
void from_within(Walk boundary_walk, const Fixture& fixture);
void from_everywhere(Walk boundary_walk, const Fixture& fixture);

/// Walks on a mesh of a million half-edges, with few reads for each step.
void cost(Walk boundary_walk);

}  // namespace course::walk_checks
