// Picture "smoothing": a noisy ball under Laplacian smoothing, and under
// Taubin's, which takes every other step outwards.
#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// Where the vertices are after a number of steps, and what that makes of the
/// ball.
struct Smoothed {
    std::vector<Vec3> positions;
    double volume =
        0;             ///< that of the faces, by the reference of signed_volume
    double bumps = 0;  ///< standard deviation of the distance from the origin,
                       ///< divided by its mean
};

/// noisy_sphere() after 0, 1, ..., 2 * pairs steps of the reference of
/// `smooth`, by turns with the weights `first` and `second`.
/// Precondition: has_solutions().
std::vector<Smoothed> smoothed_ball(int pairs, double first, double second);

}  // namespace course
