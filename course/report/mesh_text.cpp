#include "course/report/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "course/report/mesh_layout.h"

namespace course {

namespace {

// All lengths are in dots: a character has 2 x 4 of them, and they are square.
constexpr int wide = 2, high = 4;
constexpr double margin = 10;       // room for numbers outside of the mesh
constexpr double label_offset = 6;  // of a number from its edge
// Where along its edge a number may stand, the best place first.
constexpr double label_places[] = {0.45, 0.55, 0.35, 0.65, 0.25, 0.75};
constexpr std::size_t most_half_edges = 40;

/// Characters with dots in them, and texts over them.
class Canvas {
public:
    Canvas(int columns, int lines)
        : columns_(columns),
          dots_(static_cast<std::size_t>(columns * lines), 0),
          text_(static_cast<std::size_t>(columns * lines), 0) {}

    void line(Point a, Point b) {
        const int steps = static_cast<int>(2 * length(b - a)) + 1;
        for (int k = 0; k <= steps; ++k)
            dot(a + (static_cast<double>(k) / steps) * (b - a));
    }

    /// Writes a text around a point, over what is there.
    void write_over(Point at, const std::string& text) { put(at, text, false); }

    /// The same; false, and nothing, where a text or a line is in the way.
    bool write(Point at, const std::string& text) {
        return put(at, text, true);
    }

    /// The lines, without blanks at their ends and without empty ones at the
    /// end of the drawing.
    std::string text() const {
        std::string all;
        for (std::size_t begin = 0; begin < dots_.size();
             begin += static_cast<std::size_t>(columns_)) {
            all += line_from(begin);
            while (all.ends_with(' ')) all.pop_back();
            all += '\n';
        }
        while (all.ends_with("\n\n")) all.pop_back();
        return all;
    }

private:
    bool put(Point at, const std::string& text, bool only_where_free) {
        const int line = static_cast<int>(at.y) / high;
        const int size = static_cast<int>(text.size());
        const int first = static_cast<int>(at.x) / wide - size / 2;
        if (first < 0 || first + size > columns_ || !is_line(line))
            return false;
        if (only_where_free && !is_free(first, size, line)) return false;
        std::copy(
            text.begin(), text.end(),
            text_.begin() + static_cast<std::ptrdiff_t>(index(first, line)));
        return true;
    }

    /// No line there, and no text there or next to it.
    bool is_free(int first, int size, int line) const {
        for (int k = -1; k <= size; ++k) {
            const int column = first + k;
            if (column < 0 || column >= columns_) continue;
            const bool inside = k >= 0 && k < size;
            if (text_[index(column, line)] != 0 ||
                (inside && dots_[index(column, line)] != 0))
                return false;
        }
        return true;
    }

    bool is_line(int line) const {
        return line >= 0 && index(0, line) < dots_.size();
    }
    std::size_t index(int column, int line) const {
        return static_cast<std::size_t>(line) *
                   static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    void dot(Point at) {
        // The bits of the dots, as Unicode numbers them: by column.
        constexpr unsigned char bits[high][wide] = {
            {0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
        const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
        if (x < 0 || x / wide >= columns_ || y < 0 || !is_line(y / high))
            return;
        dots_[index(x / wide, y / high)] |= bits[y % high][x % wide];
    }

    std::string line_from(std::size_t begin) const {
        std::string line;
        for (std::size_t k = begin;
             k < begin + static_cast<std::size_t>(columns_); ++k)
            if (text_[k] != 0)
                line += text_[k];
            else if (dots_[k] == 0)
                line += ' ';
            else  // U+2800 and the dots, in UTF-8
                line += fmt::format("\xE2{}{}",
                                    static_cast<char>(0xA0 | (dots_[k] >> 6)),
                                    static_cast<char>(0x80 | (dots_[k] & 63)));
        return line;
    }

    int columns_;
    std::vector<unsigned char> dots_;
    std::vector<char> text_;
};

/// Of a half-edge: where it begins and ends in the drawing.
struct Arrow {
    int i;
    Point from, to;
};

std::vector<Arrow> arrows_of(const std::vector<HalfEdge>& rows,
                             const MeshLayout& layout) {
    std::vector<Arrow> arrows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int opp = rows[i].opp;
        if (opp < 0 || static_cast<std::size_t>(opp) >= rows.size()) continue;
        const auto from = layout.vertex(rows[i].vi);
        const auto to = layout.vertex(rows[static_cast<std::size_t>(opp)].vi);
        if (from && to && length(*to - *from) > 0)
            arrows.push_back({static_cast<int>(i), *from, *to});
    }
    return arrows;
}

/// Writes the number of a half-edge on the left of the edge, in its own face;
/// false where there is no room.
bool write_number(Canvas& canvas, const Arrow& arrow, bool is_walked) {
    const Point edge = arrow.to - arrow.from;
    const Point left = 1 / length(edge) * Point{edge.y, -edge.x};
    const Point off = label_offset * left;
    const std::string number =
        fmt::format("{}{}", is_walked ? ">" : "", arrow.i);
    return std::any_of(
        std::begin(label_places), std::end(label_places), [&](double place) {
            return canvas.write(arrow.from + place * edge + off, number);
        });
}

/// The middle of each face, of the corners that its rows name.
std::map<int, Point> middles(const std::vector<HalfEdge>& rows,
                             const MeshLayout& layout) {
    std::map<int, std::vector<Point>> corners;
    for (const HalfEdge& row : rows)
        if (const auto at = layout.vertex(row.vi); at && row.fi >= 0)
            corners[row.fi].push_back(*at);
    std::map<int, Point> middle;
    for (const auto& [f, points] : corners)
        for (const Point p : points)
            middle[f] = middle[f] + 1 / static_cast<double>(points.size()) * p;
    return middle;
}

}  // namespace

std::string mesh_text(const MeshPicture& mesh, const Walk& walk, int columns,
                      int lines) {
    if (mesh.positions.empty() || mesh.rows.size() > most_half_edges) return "";
    const auto layout =
        mesh_layout(mesh, {.widest = static_cast<double>(wide * columns - 1),
                           .highest = static_cast<double>(high * lines - 1),
                           .margin = margin,
                           .nearest_vertices = 12});
    if (!layout || !layout->flat) return "";
    Canvas canvas(columns, lines);
    const std::set<int> walked(walk.steps.begin(), walk.steps.end());
    std::set<int> vertices;
    const std::vector<Arrow> arrows = arrows_of(mesh.rows, *layout);
    for (const Arrow& arrow : arrows) {
        const HalfEdge& row = mesh.rows[static_cast<std::size_t>(arrow.i)];
        if (arrow.i < row.opp) canvas.line(arrow.from, arrow.to);
        vertices.insert(row.vi);
    }
    for (const int v : vertices)
        canvas.write_over(*layout->vertex(v), fmt::format("V{}", v));
    for (const Arrow& arrow : arrows)
        if (!write_number(canvas, arrow, walked.contains(arrow.i))) return "";
    for (const auto& [f, middle] : middles(mesh.rows, *layout))
        canvas.write(middle, fmt::format("F{}", f));
    return canvas.text();
}

}  // namespace course
