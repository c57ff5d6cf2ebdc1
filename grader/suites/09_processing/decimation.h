// What the suites of simplification share: meshes whose coordinates are whole
// numbers, so that lengths and errors are exact, and the answer by brute force
// on loops of vertices.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "grader/suites/09_processing/editing.h"

namespace course::decimation {

using editing::Content;

/// The same mesh at random points with coordinates 0 .. range - 1: many edges
/// are of the same length when the range is small. How it lies in space is of
/// no importance to the collapse of short edges.
Fixture scattered(Fixture fixture, std::uint64_t salt, int range);

/// Each of them, with a salt of its own.
std::vector<Fixture> scattered(const std::vector<Fixture>& fixtures, int range);

/// A collapse: vertex `gone` is pulled into vertex `kept`.
struct Pull {
    int gone, kept;
};

/// Vertices a < b of each edge that has a face.
std::vector<std::pair<int, int>> edges(const Content& content);

bool on_border(const Content& content, int v);

int face_count(const Content& content);

/// The next collapse of simplification by length; none when none is legal.
std::optional<Pull> shortest(const Content& content,
                             const std::vector<Vec3>& positions);

/// Simplified by length until there are at most `faces`, or no edge may go.
Content simplified(Content content, const std::vector<Vec3>& positions,
                   int faces);

/// Vertices at whole coordinates: 24 times as large, rounded, and each moved by
/// up to `jitter` along each axis.
Fixture rounded(Fixture fixture, std::uint64_t salt, int jitter);

/// nx times ny squares of side 4 cut into triangles, at heights 0 .. rough.
Fixture terrain(int nx, int ny, std::uint64_t salt, int rough);

/// A cube of side n whose faces are n times n squares, each cut in two.
Fixture cut_cube(int n);

/// The planes that a vertex has, each as three points.
using Planes = std::vector<std::array<Vec3, 3>>;

/// Simplified by quadric error, with a list of planes for each vertex.
Content simplified_by_planes(Content content,
                             const std::vector<Vec3>& positions, int faces);

/// Six times the signed volume that the faces enclose, from the origin.
double six_volumes(const Content& content, const std::vector<Vec3>& positions);

/// Sum of the normals of all triangles, each twice its area long.
Vec3 total_normal(const Content& content, const std::vector<Vec3>& positions);

}  // namespace course::decimation
