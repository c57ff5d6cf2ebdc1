#include "course/report/mesh_layout.h"

#include <algorithm>
#include <numbers>

namespace course {

namespace {

constexpr int most_vertices = 200;

int vertex_count(const std::vector<HalfEdge>& rows) {
    int count = 0;
    for (const HalfEdge& row : rows)
        if (row.vi < most_vertices) count = std::max(count, row.vi + 1);
    return count;
}

/// Moves and scales the points into the frame.
MeshLayout framed(std::vector<Point> points, bool flat,
                  const MeshFrame& frame) {
    Point low = points.front(), high = points.front();
    for (const Point p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Point size = high - low;
    const double margin = frame.margin;
    const double scale = std::min((frame.widest - 2 * margin) / size.x,
                                  (frame.highest - 2 * margin) / size.y);
    for (Point& p : points) p = scale * (p - low) + Point{margin, margin};
    return {std::move(points), scale * size.x + 2 * margin,
            scale * size.y + 2 * margin, flat};
}

bool is_spread(const MeshLayout& layout, double nearest_vertices) {
    for (std::size_t a = 0; a < layout.at.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            // Written so that a NaN counts as not spread.
            if (!(length(layout.at[a] - layout.at[b]) >= nearest_vertices))
                return false;
    return true;
}

MeshLayout circular(std::size_t count, const MeshFrame& frame) {
    std::vector<Point> points;
    for (std::size_t v = 0; v < count; ++v) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(v) /
                             static_cast<double>(count);
        points.push_back({std::sin(angle), -std::cos(angle)});
    }
    // Two points on a circle have no width, and one has no size at all.
    if (count <= 2) points.insert(points.end(), {{-1, 0}, {1, 0}});
    MeshLayout layout = framed(std::move(points), true, frame);
    layout.at.resize(count);
    return layout;
}

/// The given positions; nothing if they are too few, not finite, or fall
/// together.
std::optional<MeshLayout> by_positions(const std::vector<Vec3>& positions,
                                       std::size_t count,
                                       const MeshFrame& frame) {
    if (count < 3 || positions.size() < count) return std::nullopt;
    std::vector<Point> points;
    bool flat = true;
    for (std::size_t v = 0; v < count; ++v)
        flat = flat && positions[v].z == positions[0].z;
    for (std::size_t v = 0; v < count; ++v) {
        const Vec3 p = positions[v];
        points.push_back(flat ? Point{p.x, -p.y}
                              : Point{p.x + 0.45 * p.y, -p.z - 0.28 * p.y});
    }
    MeshLayout layout = framed(std::move(points), flat, frame);
    if (!is_spread(layout, frame.nearest_vertices)) return std::nullopt;
    return layout;
}

}  // namespace

std::optional<MeshLayout> mesh_layout(const MeshPicture& mesh,
                                      const MeshFrame& frame) {
    const int count = vertex_count(mesh.rows);
    if (count == 0) return std::nullopt;
    const auto vertices = static_cast<std::size_t>(count);
    auto layout = by_positions(mesh.positions, vertices, frame);
    return layout ? layout : circular(vertices, frame);
}

}  // namespace course
