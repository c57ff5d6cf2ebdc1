// Forgets to divide by the length of the normal.
// Hint: Your distance to a plane grows with the size of the triangle in it.
#include "exercises/09_processing/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace {

double to_segment(Vec3 x, Vec3 p, Vec3 q) {
    double squared = dot(q - p, q - p);
    double t = squared == 0 ? 0 : dot(x - p, q - p) / squared;
    if (t < 0) t = 0;
    if (t > 1) t = 1;
    return length(x - (p + t * (q - p)));
}

double to_triangle(Vec3 x, Vec3 p, Vec3 q, Vec3 r) {
    Vec3 n = cross(q - p, r - p);
    if (dot(cross(q - p, x - p), n) > 0 && dot(cross(r - q, x - q), n) > 0 &&
        dot(cross(p - r, x - r), n) > 0)
        return std::abs(dot(x - p, n));
    return std::min(
        {to_segment(x, p, q), to_segment(x, q, r), to_segment(x, r, p)});
}

double to_surface(Vec3 x, const IndexedMesh& mesh) {
    double nearest = 1e300;
    for (FaceList::Face face : mesh.faces) {
        auto at = [&](std::size_t k) {
            return mesh.positions[static_cast<std::size_t>(face[k])];
        };
        nearest = std::min(nearest, to_triangle(x, at(0), at(1), at(2)));
    }
    return nearest;
}

double one_way(const IndexedMesh& from, const IndexedMesh& to) {
    double farthest = 0;
    for (int v : from.faces.corners()) {
        Vec3 x = from.positions[static_cast<std::size_t>(v)];
        farthest = std::max(farthest, to_surface(x, to));
    }
    return farthest;
}

}  // namespace

double hausdorff(const IndexedMesh& a, const IndexedMesh& b) {
    if (a.faces.empty() || b.faces.empty()) throw std::invalid_argument("none");
    return std::max(one_way(a, b), one_way(b, a));
}
