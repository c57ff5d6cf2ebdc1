// Points of Bezier curves and patches from Bernstein's polynomials: another way
// than de Casteljau's, to compare with.
#pragma once

#include <span>
#include <vector>

#include "course/mesh/grids.h"

namespace course::oracle {

/// How much each of n control points counts at t: (n-1 over k) t^k
/// (1-t)^(n-1-k). For 0 <= t <= 1 and n of some hundred.
std::vector<double> bernstein_weights(int n, double t);

/// The sum of the control points with their weights.
Vec3 bezier_sum(std::span<const Vec3> points, double t);

/// The same for a patch, with the products of two weights.
Vec3 bezier_patch_sum(const ControlGrid& grid, double u, double v);

}  // namespace course::oracle
