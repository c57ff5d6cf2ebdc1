// Picture "simplification": a brick by vertex clustering, beside the same
// number of triangles by edge collapse.
#pragma once

#include <array>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// A simpler mesh, and what it costs.
struct Simpler {
    IndexedMesh mesh;
    double error = 0;  ///< Hausdorff distance from the original, by the
                       ///< reference of `hausdorff`
    /// Edges with more than two faces, and how many; smaller end first.
    std::vector<std::array<int, 3>> bad_edges;
};

/// The two at about the same number of triangles.
struct TwoWays {
    double cell = 0;  ///< side of the cubes of the clustering
    Simpler clustered;
    Simpler collapsed;  ///< by the quadric error
};

/// The same mesh, simplified with cells of each of these sides.
/// Precondition: has_solutions().
std::vector<TwoWays> simplified(const IndexedMesh& mesh,
                                const std::vector<double>& cells);

}  // namespace course
