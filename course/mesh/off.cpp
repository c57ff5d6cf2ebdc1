// OFF files.
#include "course/mesh/off.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "course/mesh/file_defects.h"

namespace course {

namespace {

/// Reads line by line; after a defect it goes on as well as it can.
class OffReader {
public:
    explicit OffReader(const std::filesystem::path& file) : lines_(file) {}

    IndexedMesh read(const std::filesystem::path& file) && {
        if (read_header()) {
            read_vertices();
            read_faces();
            read_end();
        }
        defects_.throw_if_any(file);
        return std::move(mesh_);
    }

private:
    using Words = std::vector<std::string_view>;

    void bad(std::string what) {
        defects_.add(lines_.number(), std::move(what));
    }

    /// Goes to the next line with something on it; false at the end.
    bool next_words() {
        while (lines_.next()) {
            split(lines_.line(), words_);
            if (!words_.empty()) return true;
        }
        return false;
    }

    /// False when nothing after it would make sense.
    bool read_header() {
        if (!next_words()) {
            bad("the file is empty, expected OFF");
            return false;
        }
        if (words_.front() != "OFF") {
            bad(fmt::format("the first word is {}, expected OFF",
                            quoted(words_.front())));
            return false;
        }
        words_.erase(words_.begin());
        if (words_.empty() && !next_words()) {
            bad("the file ends after OFF, expected 3 counts");
            return false;
        }
        return read_counts();
    }

    bool read_counts() {
        if (words_.size() != 3) {
            bad(fmt::format("{}, expected 3: of vertices, faces and edges",
                            counted(words_.size(), "count")));
            return false;
        }
        std::array<int, 3> counts{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::string wrong = read_integer(words_[k], counts[k]);
            if (wrong.empty() && counts[k] < 0)
                wrong = fmt::format("{} is negative", quoted(words_[k]));
            if (wrong.empty()) continue;
            bad(fmt::format("counts: {}", wrong));
            return false;
        }
        vertices_ = counts[0];
        faces_ = counts[1];
        return true;
    }

    void read_vertices() {
        for (int v = 0; v < vertices_; ++v) {
            if (!next_words()) {
                bad(fmt::format("the file ends after {} of {} vertices", v,
                                vertices_));
                return;
            }
            mesh_.positions.push_back(vertex(v));
        }
    }

    Vec3 vertex(int v) {
        std::array<double, 3> p{};
        if (words_.size() != 3)
            bad(fmt::format("vertex {} has {}, expected x y z", v,
                            counted(words_.size(), "number")));
        for (std::size_t k = 0; k < words_.size(); ++k) {
            double extra = 0;
            const std::string wrong =
                read_number(words_[k], k < 3 ? p[k] : extra);
            if (!wrong.empty()) bad(fmt::format("vertex {}: {}", v, wrong));
        }
        return {p[0], p[1], p[2]};
    }

    void read_faces() {
        for (int f = 0; f < faces_; ++f) {
            if (!next_words()) {
                bad(fmt::format("the file ends after {} of {} faces", f,
                                faces_));
                return;
            }
            read_face(f);
        }
    }

    void read_face(int f) {
        int n = 0;
        std::string wrong = read_integer(words_.front(), n);
        if (wrong.empty() && n < 3)
            wrong = fmt::format(
                "the number of corners is {}, expected at "
                "least 3",
                n);
        const std::size_t after = words_.size() - 1;
        if (wrong.empty() && after < static_cast<std::size_t>(n))
            wrong = fmt::format("{} corners, but {} indices", n, after);
        if (!wrong.empty()) {
            bad(fmt::format("face {}: {}", f, wrong));
            return;
        }
        corners_.clear();
        for (int k = 1; k <= n; ++k)
            corners_.push_back(corner(f, words_[static_cast<std::size_t>(k)]));
        mesh_.faces.push_back(corners_);
        check_colour(
            f, std::span(words_).subspan(static_cast<std::size_t>(n) + 1));
    }

    int corner(int f, std::string_view word) {
        int v = 0;
        std::string wrong = read_integer(word, v);
        if (wrong.empty() && (v < 0 || v >= vertices_))
            wrong = fmt::format("names vertex {}, but there are {}, from 0", v,
                                vertices_);
        if (!wrong.empty()) bad(fmt::format("face {}: {}", f, wrong));
        return v;
    }

    void check_colour(int f, std::span<const std::string_view> words) {
        double ignored = 0;
        if (words.size() > 4)
            bad(
                fmt::format("face {}: {} numbers after the corners, but a "
                            "colour has at most 4",
                            f, words.size()));
        for (const std::string_view word : words)
            if (const std::string wrong = read_number(word, ignored);
                !wrong.empty())
                bad(fmt::format("face {}: colour: {}", f, wrong));
    }

    void read_end() {
        while (next_words())
            bad(
                fmt::format("{} after the last of {} faces, expected the end "
                            "of the file",
                            quoted(lines_.line()), faces_));
    }

    Lines lines_;
    FileDefects defects_;
    IndexedMesh mesh_;
    Words words_;
    std::vector<int> corners_;
    int vertices_ = 0;
    int faces_ = 0;
};

}  // namespace

IndexedMesh read_off(const std::filesystem::path& file) {
    return OffReader(file).read(file);
}

void write_off(const std::filesystem::path& file, const IndexedMesh& mesh) {
    require_writable(mesh);
    if (!mesh.loose_edges.empty())
        throw std::invalid_argument(
            fmt::format("the mesh has {} loose edges, for which OFF has no "
                        "form; OBJ has",
                        mesh.loose_edges.size()));
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "OFF\n{} {} 0\n", mesh.vertex_count(),
                   mesh.faces.size());
    for (const auto& [x, y, z] : mesh.positions)
        fmt::format_to(out, "{} {} {}\n", x, y, z);
    for (const auto& face : mesh.faces) {
        fmt::format_to(out, "{}", face.size());
        for (const int v : face) fmt::format_to(out, " {}", v);
        text += '\n';
    }
    replace_text(file, text);
}

}  // namespace course
