#include "course/report/mesh_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "course/report/mesh_layout.h"

namespace course {

namespace {

using Rows = std::vector<HalfEdge>;

// All lengths are in pixels of the drawing.
constexpr MeshFrame frame = {
    .widest = 500, .highest = 430, .margin = 36, .nearest_vertices = 30};
constexpr double vertex_radius = 11;
constexpr double arrow_offset = 7;   // of an arrow from its edge
constexpr double label_offset = 5;   // of its number from the arrow
constexpr double label_place = 0.4;  // of the arrow's length

/// One drawing while it is made.
class Drawing {
public:
    Drawing(const Rows& rows, MeshLayout layout, const Walk& walk)
        : rows_(rows), layout_(std::move(layout)), order_(walk_order(walk)) {}

    Html draw(std::string_view name) {
        append(out_,
               R"(<svg class="mesh" viewBox="0 0 {:.0f} {:.0f}" )"
               R"(width="{:.0f}" height="{:.0f}" role="img" )"
               R"(aria-label="Mesh {} with {} half-edges">)",
               layout_.width, layout_.height, layout_.width, layout_.height,
               name, rows_.size());
        faces();
        edges();
        // What the walk came to lies on top.
        for (int i = 0; i < size(); ++i)
            if (!order_.contains(i)) arrow(i);
        for (int i = 0; i < size(); ++i)
            if (order_.contains(i)) arrow(i);
        vertices();
        append(out_, "</svg>");
        return std::move(out_);
    }

private:
    int size() const { return static_cast<int>(rows_.size()); }
    const HalfEdge& row(int i) const {
        return rows_[static_cast<std::size_t>(i)];
    }
    bool is_row(int i) const { return i >= 0 && i < size(); }

    std::optional<Point> vertex(int v) const { return layout_.vertex(v); }
    std::optional<Point> start(int i) const { return vertex(row(i).vi); }
    std::optional<Point> tip(int i) const {
        const int after = row(i).opp == -1 ? row(i).next : row(i).opp;
        return is_row(after) ? start(after) : std::nullopt;
    }

    /// The corners of a face, if the walk round it closes.
    std::vector<Point> corners(int first) const {
        std::vector<Point> points;
        int i = first;
        do {
            if (!is_row(i) || !start(i) || points.size() == rows_.size())
                return {};
            points.push_back(*start(i));
            i = row(i).next;
        } while (i != first);
        return points;
    }

    static double twice_area(const std::vector<Point>& p) {
        double sum = 0;
        for (std::size_t k = 0; k < p.size(); ++k) {
            const Point q = p[(k + 1) % p.size()];
            sum += p[k].x * q.y - q.x * p[k].y;
        }
        return sum;
    }

    /// All fills, then all names: a face in front must not hide a name.
    void faces() {
        std::map<int, std::vector<Point>> outlines;
        for (int i = 0; i < size(); ++i)
            if (row(i).fi >= 0 && !outlines.contains(row(i).fi))
                outlines[row(i).fi] = corners(i);
        for (const auto& [f, points] : outlines)
            if (points.size() >= 3 && !is_behind(points))
                polygon(points, "face");
        for (const auto& [f, points] : outlines)
            if (points.size() >= 3) face_name(f, points);
    }

    bool is_behind(const std::vector<Point>& points) const {
        // Counter-clockwise in space is clockwise with y downwards.
        return !layout_.flat && twice_area(points) > 0;
    }

    void face_name(int f, const std::vector<Point>& points) {
        Point middle;
        for (const Point p : points)
            middle = middle + 1 / static_cast<double>(points.size()) * p;
        while (taken(middle)) middle.y += 15;
        face_labels_.push_back(middle);
        append(out_, R"(<text class="{}" x="{:.1f}" y="{:.1f}">F{}</text>)",
               is_behind(points) ? "face-label behind" : "face-label", middle.x,
               middle.y + 4, f);
    }

    bool taken(Point p) const {
        return std::any_of(face_labels_.begin(), face_labels_.end(),
                           [&](Point other) { return length(other - p) < 14; });
    }

    void polygon(const std::vector<Point>& points, std::string_view style) {
        append(out_, R"(<polygon class="{}" points=")", style);
        for (const Point p : points) append(out_, "{:.1f},{:.1f} ", p.x, p.y);
        out_.text.back() = '"';
        append(out_, "/>");
    }

    void edges() {
        for (int i = 0; i < size(); ++i)
            if (start(i) && tip(i) && (i < row(i).opp || row(i).opp == -1))
                line("edge", *start(i), *tip(i));
    }

    void line(std::string_view style, Point a, Point b) {
        append(out_,
               R"(<line class="{}" x1="{:.1f}" y1="{:.1f}" )"
               R"(x2="{:.1f}" y2="{:.1f}"/>)",
               style, a.x, a.y, b.x, b.y);
    }

    /// The arrow of half-edge i lies to the left of its edge, in its face.
    void arrow(int i) {
        if (!start(i) || !tip(i)) return;
        const Point edge = *tip(i) - *start(i);
        const double distance = length(edge);
        if (!(distance > 0)) return;
        const Point along = 1 / distance * edge;
        const Point left = {along.y, -along.x};
        const double gap = std::min(vertex_radius + 9, 0.3 * distance);
        const Point from = *start(i) + gap * along + arrow_offset * left;
        const Point to = *tip(i) - gap * along + arrow_offset * left;
        const std::string style = arrow_style(i);
        line(style, from, to - 6 * along);
        polygon({to, to - 9 * along + 4 * left, to - 9 * along - 4 * left},
                "head " + style);
        label(i, from + label_place * (to - from) + label_offset * left);
    }

    std::string arrow_style(int i) const {
        const std::string border = row(i).fi < 0 ? " border" : "";
        return (order_.contains(i) ? "he walked" : "he") + border;
    }

    void label(int i, Point at) {
        const auto walked = order_.find(i);
        const bool is_walked = walked != order_.end();
        const double half = i > 9 ? 10 : 8;
        append(out_,
               R"(<rect class="{}" x="{:.1f}" y="{:.1f}" )"
               R"(width="{:.0f}" height="15" rx="4"/>)"
               R"(<text class="{}" x="{:.1f}" y="{:.1f}">{}</text>)",
               is_walked ? "number walked" : "number", at.x - half, at.y - 7.5,
               2 * half, is_walked ? "number-text walked" : "number-text", at.x,
               at.y + 4, i);
        if (is_walked && !walked->second.empty())
            badge(walked->second, {at.x + half, at.y - 9});
    }

    /// The step at which the walk came here.
    void badge(const std::string& order, Point at) {
        const double wide = 6.0 * static_cast<double>(order.size()) + 7;
        append(out_,
               R"(<rect class="step" x="{:.1f}" y="{:.1f}" )"
               R"(width="{:.0f}" height="13" rx="6"/>)"
               R"(<text class="step-text" x="{:.1f}" y="{:.1f}">{})"
               R"(</text>)",
               at.x - 5, at.y - 7, wide, at.x - 5 + wide / 2, at.y + 3, order);
    }

    void vertices() {
        std::set<int> used;
        for (int i = 0; i < size(); ++i)
            if (start(i)) used.insert(row(i).vi);
        for (const int v : used) {
            const Point p = *vertex(v);
            append(out_,
                   R"(<circle class="vertex" cx="{:.1f}" )"
                   R"(cy="{:.1f}" r="{:.0f}"/><text )"
                   R"(class="vertex-text" x="{:.1f}" y="{:.1f}">)"
                   R"(V{}</text>)",
                   p.x, p.y, vertex_radius, p.x, p.y + 3.5, v);
        }
    }

    const Rows& rows_;
    const MeshLayout layout_;
    const std::map<int, std::string> order_;
    std::vector<Point> face_labels_;
    Html out_;
};

}  // namespace

Html mesh_drawing(const MeshPicture& mesh, const Walk& walk) {
    if (mesh.rows.size() > most_drawn_half_edges) return {};
    const auto layout = mesh_layout(mesh, frame);
    if (!layout) return {};
    return Drawing(mesh.rows, *layout, walk).draw(mesh.name);
}

}  // namespace course
