// Where the vertices of a small mesh lie in a drawing of it.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "course/runner/results.h"

namespace course {

/// A point of a drawing; y grows downwards.
struct Point {
    double x = 0, y = 0;

    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
};

inline double length(Point a) {
    return std::hypot(a.x, a.y);
}

/// The room that there is, all in the unit of the drawing.
struct MeshFrame {
    double widest, highest;
    double margin;            ///< on each side, for what lies beside the mesh
    double nearest_vertices;  ///< where two are nearer, nobody can tell them
};

struct MeshLayout {
    std::vector<Point> at;  ///< of each vertex
    double width = 0, height = 0;
    bool flat = true;  ///< false: faces may lie behind one another

    /// Nothing when there is no such vertex.
    std::optional<Point> vertex(int v) const {
        if (v < 0 || static_cast<std::size_t>(v) >= at.size())
            return std::nullopt;
        return at[static_cast<std::size_t>(v)];
    }
};

/// The layout of the vertices that the rows name: by the mesh's positions, seen
/// a little from above when they lie in space; on a circle where there are no
/// usable ones. Nothing for a mesh without vertices. Any numbers may stand in
/// the rows.
std::optional<MeshLayout> mesh_layout(const MeshPicture& mesh,
                                      const MeshFrame& frame);

}  // namespace course
