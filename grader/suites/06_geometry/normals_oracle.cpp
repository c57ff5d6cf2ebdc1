#include "grader/suites/06_geometry/normals_oracle.h"

#include <cmath>

namespace course::normals {

namespace {

using Real = long double;

struct Wide {
    Real x, y, z;
};

Wide from_to(Vec3 a, Vec3 b) {
    return {Real{b.x} - Real{a.x}, Real{b.y} - Real{a.y},
            Real{b.z} - Real{a.z}};
}

Real squared(Wide v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// Corner k counted round and round.
Vec3 corner(std::span<const Vec3> corners, std::size_t k) {
    return corners[k % corners.size()];
}

}  // namespace

std::vector<Vec3> corners_of(const IndexedMesh& mesh, int f) {
    std::vector<Vec3> corners;
    for (const int v : mesh.faces[f])
        corners.push_back(mesh.positions[static_cast<std::size_t>(v)]);
    return corners;
}

Vec3 twice_shadows(std::span<const Vec3> corners) {
    Real x = 0, y = 0, z = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Wide p = from_to(corners[0], corner(corners, k));
        const Wide q = from_to(corners[0], corner(corners, k + 1));
        x += (p.y - q.y) * (p.z + q.z);
        y += (p.z - q.z) * (p.x + q.x);
        z += (p.x - q.x) * (p.y + q.y);
    }
    return {static_cast<double>(x), static_cast<double>(y),
            static_cast<double>(z)};
}

Vec3 sum_over_corners(std::span<const Vec3> corners) {
    Real x = 0, y = 0, z = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Wide in = from_to(corners[k], corner(corners, k + 1));
        const Wide out =
            from_to(corner(corners, k + 1), corner(corners, k + 2));
        x += in.y * out.z - in.z * out.y;
        y += in.z * out.x - in.x * out.z;
        z += in.x * out.y - in.y * out.x;
    }
    return {static_cast<double>(x), static_cast<double>(y),
            static_cast<double>(z)};
}

double squared_sides(std::span<const Vec3> corners) {
    Real sum = 0;
    for (std::size_t k = 0; k < corners.size(); ++k)
        sum += squared(from_to(corners[k], corner(corners, k + 1)));
    return static_cast<double>(sum);
}

double angle_at(Vec3 at, Vec3 p, Vec3 q) {
    const Real a = std::sqrt(squared(from_to(at, p)));
    const Real b = std::sqrt(squared(from_to(at, q)));
    const Real c = std::sqrt(squared(from_to(p, q)));
    // Half the angle, by the sides (Heron's way).
    const Real over = ((c - a + b) * (c + a - b));
    const Real under = ((a + b + c) * (a + b - c));
    return static_cast<double>(2 *
                               std::atan2(std::sqrt(over > 0 ? over : 0),
                                          std::sqrt(under > 0 ? under : 0)));
}

double volume_below(const IndexedMesh& mesh) {
    if (mesh.faces.empty()) return 0;
    const Vec3 ground =
        mesh.positions[static_cast<std::size_t>(mesh.faces[0][0])];
    Real volume = 0;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::vector<Vec3> corners = corners_of(mesh, f);
        const Wide a = from_to(ground, corners[0]);
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const Wide b = from_to(ground, corners[k]);
            const Wide c = from_to(ground, corners[k + 1]);
            const Real shadow =
                ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
            volume += shadow * (a.z + b.z + c.z) / 3;
        }
    }
    return static_cast<double>(volume);
}

}  // namespace course::normals
