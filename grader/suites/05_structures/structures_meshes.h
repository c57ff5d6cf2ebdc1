// Meshes of triangles, for the suites of the structures that the lecture shows
// on them.
#pragma once

#include <vector>

#include "course/mesh/soup.h"
#include "course/mesh/zoo.h"

namespace course::hidden {

/// Fixtures of the zoo and of the suites with triangles only and with no loose
/// edges: closed and open ones, bow-ties, neighbours that share several edges.
std::vector<Fixture> triangle_meshes();

/// Larger ones, regular and random, renumbered; the same for the same seed of
/// the run.
std::vector<Fixture> generated_triangle_meshes();

/// Its triangles as a soup. Precondition: all faces are triangles.
Soup torn(const IndexedMesh& mesh);

}  // namespace course::hidden
