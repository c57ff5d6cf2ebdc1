#include "exercises/09_processing/hausdorff.h"

#include <algorithm>
#include <limits>
#include <set>

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

double to_segment(Vec3 x, Vec3 p, Vec3 q) {
    Vec3 along = q - p;
    double squared = dot(along, along);
    double t = squared > 0 ? dot(x - p, along) / squared : 0;
    return length(x - (p + std::clamp(t, 0.0, 1.0) * along));
}

/// Whether x, seen along the normal n, lies inside the triangle.
bool is_above(Vec3 x, Vec3 p, Vec3 q, Vec3 r, Vec3 n) {
    return dot(cross(q - p, x - p), n) > 0 && dot(cross(r - q, x - q), n) > 0 &&
           dot(cross(p - r, x - r), n) > 0;
}

double to_triangle(Vec3 x, Vec3 p, Vec3 q, Vec3 r) {
    Vec3 n = cross(q - p, r - p);
    double nearest = std::min(
        {to_segment(x, p, q), to_segment(x, q, r), to_segment(x, r, p)});
    if (is_above(x, p, q, r, n))
        nearest = std::min(nearest, std::abs(dot(x - p, n)) / length(n));
    return nearest;
}

double to_surface(Vec3 x, const IndexedMesh& mesh) {
    double nearest = std::numeric_limits<double>::infinity();
    for (FaceList::Face face : mesh.faces)
        nearest = std::min(nearest, to_triangle(x, mesh.positions[at(face[0])],
                                                mesh.positions[at(face[1])],
                                                mesh.positions[at(face[2])]));
    return nearest;
}

/// The largest distance of a vertex of `from` to the surface of `to`.
double one_way(const IndexedMesh& from, const IndexedMesh& to) {
    std::set<int> used(from.faces.corners().begin(),
                       from.faces.corners().end());
    double farthest = 0;
    for (int v : used)
        farthest = std::max(farthest, to_surface(from.positions[at(v)], to));
    return farthest;
}

}  // namespace

double hausdorff(const IndexedMesh& a, const IndexedMesh& b) {
    if (a.faces.empty() || b.faces.empty())
        throw std::invalid_argument("a mesh without a face has no surface");
    return std::max(one_way(a, b), one_way(b, a));
}
