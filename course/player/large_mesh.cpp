#include "course/player/large_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/file_defects.h"
#include "course/player/page.h"

namespace course {

namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63]
                                          : '=';
    }
    return text;
}

/// Each number as its difference to the one `stride` places before, small ones
/// of either sign in few bytes of seven bits.
std::string packed(const std::vector<int>& numbers, std::size_t stride) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::int64_t step =
            std::int64_t{numbers[i]} - (i < stride ? 0 : numbers[i - stride]);
        auto rest =
            static_cast<std::uint64_t>(step < 0 ? -2 * step - 1 : 2 * step);
        for (; rest >= 128; rest >>= 7)
            bytes.push_back(static_cast<std::uint8_t>(rest | 128));
        bytes.push_back(static_cast<std::uint8_t>(rest));
    }
    return base64(bytes);
}

/// Coordinates 0 .. 65535 along the longest side of the box.
std::vector<int> quantised(const std::vector<Vec3>& positions) {
    if (positions.empty()) return {};
    Vec3 low = positions.front();
    Vec3 high = low;
    for (const Vec3& p : positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y),
               std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y),
                std::max(high.z, p.z)};
    }
    // Halved, so that the size of the largest boxes is finite.
    const Vec3 half = 0.5 * high - 0.5 * low;
    const double side = std::max({half.x, half.y, half.z});
    const double scale = side > 0 ? 65535 / side : 0;
    std::vector<int> numbers;
    for (const Vec3& p : positions)
        for (const double d : {0.5 * p.x - 0.5 * low.x, 0.5 * p.y - 0.5 * low.y,
                               0.5 * p.z - 0.5 * low.z})
            numbers.push_back(static_cast<int>(std::lround(d * scale)));
    return numbers;
}

/// Runs of faces with the same number of sides: how many faces, how many sides.
std::vector<int> runs_of_sides(const FaceList& faces) {
    std::vector<int> runs;
    for (const auto& face : faces) {
        const int sides = static_cast<int>(face.size());
        if (runs.empty() || runs.back() != sides) {
            runs.push_back(0);
            runs.push_back(sides);
        }
        ++runs[runs.size() - 2];
    }
    return runs;
}

/// FNV-1a over the cells of the table.
std::uint32_t sum_of(const HalfEdgeTable& he) {
    std::uint32_t sum = 2166136261U;
    for (const HalfEdge& row : he.rows())
        for (const int cell : {row.vi, row.fi, row.next, row.opp})
            sum = (sum ^ static_cast<std::uint32_t>(cell)) * 16777619U;
    return sum;
}

/// Lists as {"count", "packed"}.
std::string json_of(const std::vector<int>& numbers, std::size_t stride) {
    return fmt::format(R"({{"count":{},"stride":{},"packed":"{}"}})",
                       numbers.size(), stride, packed(numbers, stride));
}

std::vector<int> ends_of(const std::vector<std::array<int, 2>>& edges) {
    std::vector<int> ends;
    for (const auto& edge : edges)
        ends.insert(ends.end(), edge.begin(), edge.end());
    return ends;
}

}  // namespace

std::string large_mesh_page(const std::string& title, const IndexedMesh& mesh,
                            const std::string& recording) {
    const HalfEdgeTable he = build(mesh);
    require_writable(mesh);
    const std::string data = fmt::format(
        R"({{"mesh":{{"positions":{},"sides":{},"corners":{},"loose":{},)"
        R"("half_edges":{},"sum":{}}},"recording":{}}})",
        json_of(quantised(mesh.positions), 3),
        json_of(runs_of_sides(mesh.faces), 1), json_of(mesh.faces.corners(), 1),
        json_of(ends_of(mesh.loose_edges), 1), he.size(), sum_of(he),
        recording);
    return make_page(
        {.title = title,
         .styles = {"base.css", "parts.css", "view3d.css"},
         .body = "view3d.html",
         .scripts = {"svg.js", "table.js", "code.js", "stepper.js", "steps.js",
                     "say.js", "words.js", "large_table.js", "raster.js",
                     "arrows3d.js", "view3d.js"},
         .data = data});
}

}  // namespace course
