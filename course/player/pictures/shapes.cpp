#include "course/player/pictures/shapes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "course/mesh/generators.h"

namespace course {

namespace {

/// Distance from the axis and height, from the middle of the foot to the top.
constexpr std::array<std::array<double, 2>, 10> profile = {{
    {0.85, 0},
    {0.85, 0.2},
    {0.6, 0.35},
    {0.5, 0.5},
    {0.22, 1.05},
    {0.18, 1.5},
    {0.45, 1.6},
    {0.2, 1.7},
    {0.42, 2.05},
    {0.3, 2.32},
}};
constexpr double top = 2.42;

std::vector<Vec3> ring_points(int sides) {
    std::vector<Vec3> points = {{0, 0, 0}, {0, 0, top}};
    for (const auto& [radius, height] : profile)
        for (int s = 0; s < sides; ++s) {
            const double angle = 2 * std::numbers::pi * s / sides;
            points.push_back(
                {radius * std::cos(angle), radius * std::sin(angle), height});
        }
    return points;
}

/// Uneven by up to 1, by the same numbers everywhere.
double next_noise(std::mt19937& source) {
    return static_cast<double>(source()) / 2147483648.0 - 1;
}

}  // namespace

IndexedMesh pawn(int sides) {
    if (sides < 3)
        throw std::invalid_argument(
            fmt::format("a pawn of {} sides, expected 3 or more", sides));
    IndexedMesh mesh{ring_points(sides), {}, {}};
    const auto at = [&](int ring, int s) {
        return 2 + ring * sides + s % sides;
    };
    const int last = static_cast<int>(profile.size()) - 1;
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

IndexedMesh noisy_sphere() {
    IndexedMesh mesh = icosphere(2);
    std::mt19937 source(1);
    for (Vec3& p : mesh.positions) p = (1 + 0.15 * next_noise(source)) * p;
    return mesh;
}

IndexedMesh box_corner(Cut cut) {
    const std::vector<Vec3> corners = {{3, 2, 1}, {0, 2, 1}, {0, 0, 1},
                                       {3, 0, 1}, {3, 0, 0}, {3, 2, 0},
                                       {0, 2, 0}, {0, 1, 1}, {1.5, 0, 1}};
    if (cut == Cut::first)
        return {corners,
                {{0, 1, 7},
                 {0, 7, 2},
                 {0, 2, 8},
                 {0, 8, 3},
                 {0, 3, 5},
                 {3, 4, 5},
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
