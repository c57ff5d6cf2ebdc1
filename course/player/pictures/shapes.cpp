#include "course/player/pictures/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "course/mesh/generators.h"

namespace course {

namespace {

/// A ring of a shape round the z axis: a circle, or a square of that half side.
struct Ring {
    double radius, height;
    bool is_square = false;
};

Vec3 on_ring(const Ring& ring, double turns) {
    const double angle = 2 * std::numbers::pi * turns;
    const double x = std::cos(angle), y = std::sin(angle);
    const double radius = ring.is_square
                              ? ring.radius / std::max(std::abs(x), std::abs(y))
                              : ring.radius;
    return {radius * x, radius * y, ring.height};
}

/// Closed: the rings from below to above, with a vertex in the middle of the
/// first and of the last.
IndexedMesh turned(const std::vector<Ring>& rings, int sides) {
    IndexedMesh mesh{
        {{0, 0, rings.front().height}, {0, 0, rings.back().height}}, {}, {}};
    for (const Ring& ring : rings)
        for (int s = 0; s < sides; ++s)
            mesh.positions.push_back(on_ring(ring, double(s) / sides));
    const auto at = [&](int r, int s) { return 2 + r * sides + s % sides; };
    const int last = static_cast<int>(rings.size()) - 1;
    for (int s = 0; s < sides; ++s) {
        mesh.faces.push_back({0, at(0, s + 1), at(0, s)});
        for (int r = 0; r < last; ++r) {
            mesh.faces.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
            mesh.faces.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
        }
        mesh.faces.push_back({at(last, s), at(last, s + 1), 1});
    }
    return mesh;
}

/// Uneven by up to 1, by the same numbers everywhere.
double next_noise(std::mt19937& source) {
    return static_cast<double>(source()) / 2147483648.0 - 1;
}

}  // namespace

IndexedMesh pawn() {
    return turned({{0.85, 0},
                   {0.85, 0.2},
                   {0.6, 0.35},
                   {0.5, 0.5},
                   {0.22, 1.05},
                   {0.18, 1.5},
                   {0.45, 1.6},
                   {0.2, 1.7},
                   {0.42, 2.05},
                   {0.3, 2.32}},
                  24);
}

IndexedMesh brick() {
    constexpr bool square = true;
    return turned({{0.5, 0, square},
                   {1, 0, square},
                   {1, 0.2, square},
                   {1, 0.4, square},
                   {0.85, 0.4, square},
                   {0.7, 0.4},
                   {0.55, 0.4},
                   {0.55, 0.6},
                   {0.55, 0.8},
                   {0.3, 0.8}},
                  16);
}

IndexedMesh noisy_sphere() {
    IndexedMesh mesh = icosphere(2);
    std::mt19937 source(1);
    for (Vec3& p : mesh.positions) p = (1 + 0.15 * next_noise(source)) * p;
    return mesh;
}

IndexedMesh box_corner(Cut cut) {
    const std::vector<Vec3> corners = {{3, 2, 1}, {0, 2, 1},   {0, 0, 1},
                                       {3, 0, 1}, {3, 0, 0},   {3, 2, 0},
                                       {0, 2, 0}, {3, 0, 0.5}, {3, 1, 0}};
    if (cut == Cut::first)
        return {corners,
                {{0, 1, 2},
                 {0, 2, 3},
                 {0, 3, 7},
                 {0, 7, 4},
                 {0, 4, 8},
                 {0, 8, 5},
                 {0, 5, 1},
                 {1, 5, 6}},
                {}};
    return {{corners.begin(), corners.begin() + 7},
            {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}},
            {}};
}

Json points_json(const std::vector<Vec3>& points) {
    const auto rounded = [](double x) { return std::round(x * 1000) / 1000; };
    std::vector<Vec3> near;
    for (const Vec3& p : points)
        near.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
    return near;
}

Json mesh_json(const IndexedMesh& mesh) {
    return Json::object(
        {{"points", points_json(mesh.positions)}, {"faces", mesh.faces}});
}

FaceList faces_left(const HalfEdgeTable& he) {
    std::set<int> seen = {-1};
    FaceList faces;
    for (const HalfEdge& row : he.rows()) {
        if (!seen.insert(row.fi).second) continue;
        std::vector<int> corners;
        const HalfEdge* at = &row;
        do {
            corners.push_back(at->vi);
            at = &he.rows()[static_cast<std::size_t>(at->next)];
        } while (at != &row);
        faces.push_back(corners);
    }
    return faces;
}

}  // namespace course
