#include "grader/suites/08_making/making_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "course/halfedge/build.h"

namespace course::oracle {

namespace {

using Sides = std::map<std::pair<int, int>, int>;

std::string side_text(std::pair<int, int> side) {
    return std::to_string(side.first) + "->" + std::to_string(side.second);
}

Vec3 at(std::span<const Vec3> points, int v) {
    return points[static_cast<std::size_t>(v)];
}

/// How many faces run along each side, in its direction.
Sides sides_of(const FaceList& faces) {
    Sides sides;
    for (const FaceList::Face face : faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            ++sides[{face[k], face[(k + 1) % face.size()]}];
    return sides;
}

/// Twice the area of a polygon, along its normal.
Vec3 polygon_area(std::span<const Vec3> polygon) {
    Vec3 sum;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum = sum + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return sum;
}

std::string bad_triangle(std::span<const Vec3> polygon,
                         const std::array<int, 3>& corners) {
    const int n = static_cast<int>(polygon.size());
    for (const int v : corners)
        if (v < 0 || v >= n)
            return "names the corner " + std::to_string(v) + " of " +
                   std::to_string(n);
    const Vec3 whole = polygon_area(polygon);
    const Vec3 a = at(polygon, corners[0]);
    const Vec3 area =
        cross(at(polygon, corners[1]) - a, at(polygon, corners[2]) - a);
    const double part = dot(area, whole) / dot(whole, whole);
    if (!(part > -1e-9)) return "is turned over";
    if (!(part > 1e-9)) return "has no area";
    return "";
}

}  // namespace

std::string malformed_mesh(const IndexedMesh& mesh, std::size_t sides) {
    if (!mesh.loose_edges.empty()) return "there are loose edges";
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = at(mesh.positions, v);
        if (!std::isfinite(p.x + p.y + p.z))
            return "vertex " + std::to_string(v) + " is not finite";
    }
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face face = mesh.faces[f];
        const std::string name = "face " + std::to_string(f);
        if (face.size() != sides)
            return name + " has " + std::to_string(face.size()) + " corners";
        for (const int v : face)
            if (v < 0 || v >= mesh.vertex_count())
                return name + " names the vertex " + std::to_string(v) +
                       " of " + std::to_string(mesh.vertex_count());
        if (std::set<int>(face.begin(), face.end()).size() != sides)
            return name + " comes to one vertex twice";
    }
    return "";
}

std::string open_side(const FaceList& faces) {
    const Sides sides = sides_of(faces);
    for (const auto& [side, count] : sides) {
        if (count > 1)
            return "two faces run along " + side_text(side) + " the same way";
        if (!sides.contains({side.second, side.first}))
            return "only one face runs along " + side_text(side);
    }
    return "";
}

double enclosed_volume(const IndexedMesh& mesh) {
    double volume = 0;
    for (const FaceList::Face face : mesh.faces)
        volume += dot(at(mesh.positions, face[0]),
                      cross(at(mesh.positions, face[1]),
                            at(mesh.positions, face[2]))) /
                  6;
    return volume;
}

Vec3 doubled_area(const IndexedMesh& mesh, FaceList::Face triangle) {
    const Vec3 a = at(mesh.positions, triangle[0]);
    return cross(at(mesh.positions, triangle[1]) - a,
                 at(mesh.positions, triangle[2]) - a);
}

std::string bad_cut(std::span<const Vec3> polygon,
                    const std::vector<std::array<int, 3>>& triangles) {
    if (triangles.size() + 2 != polygon.size())
        return std::to_string(triangles.size()) + " triangles for " +
               std::to_string(polygon.size()) + " corners";
    FaceList faces;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const std::string why = bad_triangle(polygon, triangles[t]);
        if (!why.empty()) return "triangle " + std::to_string(t) + " " + why;
        faces.push_back(triangles[t]);
    }
    // The outside of the polygon as one more face: then all must be closed.
    std::vector<int> outside(polygon.size());
    for (std::size_t k = 0; k < outside.size(); ++k)
        outside[k] = static_cast<int>(outside.size() - 1 - k);
    faces.push_back(outside);
    return open_side(faces);
}

FaultMatcher<std::vector<std::array<int, 3>>> CutsUp(
    std::vector<Vec3> polygon) {
    return {"the polygon in triangles",
            [polygon = std::move(polygon)](const auto& triangles) {
                return bad_cut(polygon, triangles);
            }};
}

Fixture as_mesh(const std::string& name, std::span<const Vec3> polygon) {
    IndexedMesh mesh;
    mesh.positions.assign(polygon.begin(), polygon.end());
    std::vector<int> face(polygon.size());
    for (std::size_t k = 0; k < face.size(); ++k) face[k] = static_cast<int>(k);
    mesh.faces.push_back(face);
    return {name, mesh, build(mesh)};
}

std::vector<Vec3> moved(std::span<const Vec3> points, double scale, Vec3 by) {
    // The rows of a rotation: (2,-1,2)/3, (2,2,-1)/3, (-1,2,2)/3.
    std::vector<Vec3> result;
    for (const Vec3 p : points)
        result.push_back(by + (scale / 3) * Vec3{2 * p.x - p.y + 2 * p.z,
                                                 2 * p.x + 2 * p.y - p.z,
                                                 2 * p.y + 2 * p.z - p.x});
    return result;
}

}  // namespace course::oracle
