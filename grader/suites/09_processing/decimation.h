// What the suites of simplification share: meshes whose coordinates are whole
// numbers, so that lengths and errors are exact, and the answer by brute force
// on loops of vertices.
#pragma once

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

}  // namespace course::decimation
