// More hidden meshes, for this chapter: borders that the others do not have.
#pragma once

#include <vector>

#include "course/mesh/zoo.h"

namespace course::hidden {

Fixture fan_with_gap();  ///< a border vertex with nineteen edges
Fixture windows();       ///< four border loops

/// Random meshes with many border loops, several components, open and closed
/// ones, and bow-ties; and those that generated_fixtures() makes.
std::vector<Fixture> generated_borders();

}  // namespace course::hidden
