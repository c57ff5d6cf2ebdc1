// OBJ files, through tinyobjloader, behind a check of what it would let pass.
//
// Version 2.0.0rc10 was measured on both of its interfaces. Without a word, or
// with a warning only, it
//   - reads `abc`, `nan`, `inf` and missing coordinates as 0, `0,5` as 0 and
//     1e999 as infinity, and is off by a bit or so in every second number of
//     six digits, so that a mesh does not survive a round trip;
//   - reads `1x` as 1, an index of 11 digits as some other one, and lets
//     indices out of range pass, relative ones even without the warning;
//   - takes `\` at the end of a line, and a comment there, for an index;
//   - counts sides in 8 bits (300 come out as 44, 256 as 0), drops faces of
//     one or two corners, and `l` lines when a `g` line follows;
//   - passes over words that it does not know, such as `face`, and the first
//     line after a byte order mark.
// So it gets only indices that hold nothing of this, by the interface that
// counts sides as int. That one has no callback for `l` lines; the indices of
// both are written alike, and it gets those of many lines as one `f` line,
// since it works on each line before it looks at the indices.
#include "course/mesh/obj.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "course/mesh/file_defects.h"

namespace course {

namespace {

enum class Keyword { v, f, l };

constexpr std::array<std::string_view, 16> passed_over = {
    "vp",       "p",        "g",          "s",        "o",      "mg",
    "lod",      "usemtl",   "mtllib",     "usemap",   "maplib", "bevel",
    "c_interp", "d_interp", "shadow_obj", "trace_obj"};

/// `1`, `1/2`, `1//3` or `1/2/3`; returns what is wrong with it, or "".
std::string index_defect(std::string_view word) {
    std::vector<std::string_view> parts;
    for (std::string_view rest = word;;) {
        const std::size_t slash = rest.find('/');
        parts.push_back(rest.substr(0, slash));
        if (slash == std::string_view::npos) break;
        rest.remove_prefix(slash + 1);
    }
    if (parts.size() == 3 && parts[1].empty()) parts.erase(parts.begin() + 1);
    if (parts.size() > 3)
        return fmt::format("{} has more than three parts", quoted(word));
    for (const std::string_view part : parts) {
        int index = 0;
        if (part.empty())
            return fmt::format("{} lacks an index beside a slash",
                               quoted(word));
        if (std::string wrong = read_integer(part, index); !wrong.empty())
            return wrong;
        if (index == 0)
            return fmt::format("{} has an index 0, but they begin at 1",
                               quoted(word));
    }
    return {};
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// How many corners the line has, when all of them are `1`, `1/2`, `1//3` or
/// `1/2/3` of at most nine digits that do not begin with 0: most lines are like
/// that, and need no closer look. -1 for any other.
int plain_corners(std::string_view corners) {
    const char* at = corners.data();
    const char* const end = at + corners.size();
    for (int count = 0;; ++count) {
        while (at != end && is_blank(*at)) ++at;
        if (at == end) return count;
        for (int slashes = 0;; ++slashes) {
            const char* const first = at;
            while (at != end && *at >= '0' && *at <= '9') ++at;
            const auto digits = at - first;
            if (digits > 9 || (digits == 0 ? slashes != 1 : *first == '0'))
                return -1;
            if (at == end || is_blank(*at)) {
                if (digits == 0) return -1;
                break;
            }
            if (*at++ != '/' || slashes == 2) return -1;
        }
    }
}

/// Three finite numbers and nothing else: most vertices are that, and need no
/// closer look.
bool is_plain(std::string_view words, std::array<double, 7>& numbers) {
    const char* at = words.data();
    const char* const end = at + words.size();
    for (int k = 0; k < 3; ++k) {
        if (at == end || !is_blank(*at)) return false;
        while (at != end && is_blank(*at)) ++at;
        const auto [after, error] =
            std::from_chars(at, end, numbers[static_cast<std::size_t>(k)]);
        if (error != std::errc()) return false;
        at = after;
    }
    return at == end && std::isfinite(numbers[0]) &&
           std::isfinite(numbers[1]) && std::isfinite(numbers[2]);
}

/// A line whose indices tinyobjloader sees, and what else is to be known of it.
struct Statement {
    Keyword keyword = Keyword::f;
    int line = 0;
    int corners = 0;
    /// How many of them came before it.
    int vertices = 0, textures = 0, normals = 0;
};

/// The indices of f and l lines as tinyobjloader may see them, those of a few
/// thousand lines at a time as one line; its callback asks what belongs to
/// them. The vertices, which it would round, go into `positions` at once.
class CheckedLines : public std::streambuf {
public:
    CheckedLines(const std::filesystem::path& file, FileDefects& defects,
                 std::vector<Vec3>& positions)
        : lines_(file), defects_(defects), positions_(positions) {}

    /// Those of the line that tinyobjloader has read last.
    const std::vector<Statement>& statements() const { return statements_; }

    int textures() const { return textures_; }
    int normals() const { return normals_; }

protected:
    int_type underflow() override {
        constexpr std::size_t enough = std::size_t{1} << 15;
        text_ = 'f';
        statements_.clear();
        while (text_.size() < enough && next_line()) check();
        if (statements_.empty()) return traits_type::eof();
        text_ += '\n';
        setg(text_.data(), text_.data(), text_.data() + text_.size());
        return traits_type::to_int_type(text_.front());
    }

private:
    /// Joins lines that end in a backslash; false at the end of the file.
    bool next_line() {
        if (!lines_.next()) return false;
        number_ = lines_.number();
        line_ = lines_.line();
        if (line_.ends_with('\\')) join();
        return true;
    }

    void join() {
        joined_ = line_;
        while (joined_.ends_with('\\')) {
            joined_.back() = ' ';
            if (lines_.next())
                joined_ += lines_.line();
            else
                defects_.add(number_, "the file ends after a `\\`");
        }
        line_ = joined_;
    }

    /// Reports the line's defects.
    void check() {
        const std::string_view word(
            line_.begin(), std::find_if(line_.begin(), line_.end(), is_blank));
        if (word == "v")
            read_vertex();
        else if (word == "f")
            check_indices(Keyword::f);
        else if (word == "l")
            check_indices(Keyword::l);
        else if (word == "vt")
            ++textures_;
        else if (word == "vn")
            ++normals_;
        else if (!word.empty() &&
                 std::find(passed_over.begin(), passed_over.end(), word) ==
                     passed_over.end())
            defects_.add(number_, fmt::format("{} is no keyword known here",
                                              quoted(word)));
    }

    /// A bad vertex counts as one, for the sake of the indices after it.
    void read_vertex() {
        std::array<double, 7> numbers{};
        const std::string_view words = line_.substr(1);
        if (!is_plain(words, numbers)) check_numbers(words, numbers);
        positions_.push_back({numbers[0], numbers[1], numbers[2]});
    }

    void check_numbers(std::string_view words, std::array<double, 7>& numbers) {
        split(words, words_);
        numbers = {};
        const std::size_t n = words_.size();
        if (n != 3 && n != 4 && n != 6 && n != 7)
            defects_.add(number_, fmt::format("v has {}, expected x y z (then "
                                              "perhaps w, or a colour)",
                                              counted(n, "number")));
        for (std::size_t k = 0; k < std::min(n, numbers.size()); ++k)
            if (std::string wrong = read_number(words_[k], numbers[k]);
                !wrong.empty())
                defects_.add(number_, fmt::format("v: {}", wrong));
    }

    void check_indices(Keyword keyword) {
        const std::string_view corners = line_.substr(1);
        const int least = keyword == Keyword::f ? 3 : 2;
        int n = plain_corners(corners);
        if (n >= least)
            text_ += corners;
        else
            n = check_corners(corners, keyword == Keyword::f ? "f" : "l",
                              least);
        if (n > 0)
            statements_.push_back({keyword, number_, n,
                                   static_cast<int>(positions_.size()),
                                   textures_, normals_});
    }

    int check_corners(std::string_view corners, const char* name, int least) {
        split(corners, words_);
        const int n = static_cast<int>(words_.size());
        if (n < least)
            defects_.add(number_,
                         fmt::format("{} has {}, expected at least {}", name,
                                     counted(words_.size(), "corner"), least));
        for (std::size_t k = 0; k < words_.size(); ++k) {
            text_ += ' ';
            text_ += checked(words_[k], name, k + 1);
        }
        return n;
    }

    /// What is bad goes on as index 0, which means none, so that the others of
    /// the line are looked at.
    std::string_view checked(std::string_view word, const char* name,
                             std::size_t corner) {
        const std::string wrong = index_defect(word);
        if (wrong.empty()) return word;
        defects_.add(number_,
                     fmt::format("{}: corner {}: {}", name, corner, wrong));
        return "0";
    }

    Lines lines_;
    FileDefects& defects_;
    std::vector<Vec3>& positions_;
    std::vector<std::string_view> words_;
    std::string joined_;
    std::string text_;
    std::vector<Statement> statements_;
    std::string_view line_;
    int number_ = 0;
    int textures_ = 0;
    int normals_ = 0;
};

/// Takes what tinyobjloader finds and makes a mesh of it.
class ObjMesh {
public:
    explicit ObjMesh(const std::filesystem::path& file)
        : lines_(file, defects_, mesh_.positions) {}

    IndexedMesh read(const std::filesystem::path& file) && {
        tinyobj::callback_t callbacks;
        callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int n) {
            static_cast<ObjMesh*>(self)->add_indices(
                {indices, static_cast<std::size_t>(n)});
        };
        std::istream in(&lines_);
        in.exceptions(std::ios::badbit);  // or a bad_alloc would end the file
        std::string wrong;
        if (!tinyobj::LoadObjWithCallback(in, callbacks, this, nullptr, nullptr,
                                          &wrong))
            defects_.add(0, wrong);
        check_forward_references();
        defects_.throw_if_any(file);
        return std::move(mesh_);
    }

private:
    enum class Pool { vertices, textures, normals };

    /// An index to what had not come yet in the file.
    struct ForwardReference {
        int line;
        int corner;
        Pool pool;
        int index;
    };

    int count(Pool pool) const {
        if (pool == Pool::vertices) return mesh_.vertex_count();
        return pool == Pool::textures ? lines_.textures() : lines_.normals();
    }

    static const char* name(Pool pool) {
        if (pool == Pool::vertices) return "vertices (v)";
        return pool == Pool::textures ? "texture coordinates (vt)"
                                      : "normals (vn)";
    }

    /// Those of the lines that were given to tinyobjloader as one.
    void add_indices(std::span<const tinyobj::index_t> indices) {
        std::size_t given = 0;
        for (const Statement& at : lines_.statements())
            given += static_cast<std::size_t>(at.corners);
        if (indices.size() != given)
            throw std::logic_error("tinyobjloader found other corners");
        for (const Statement& at : lines_.statements()) {
            const auto n = static_cast<std::size_t>(at.corners);
            add_line(at, indices.first(n));
            indices = indices.subspan(n);
        }
    }

    void add_line(const Statement& at,
                  std::span<const tinyobj::index_t> indices) {
        vertices_.clear();
        for (const tinyobj::index_t& index : indices) {
            const int corner = static_cast<int>(vertices_.size()) + 1;
            vertices_.push_back(resolve(at, Pool::vertices, at.vertices,
                                        index.vertex_index, corner));
            if (index.texcoord_index != 0)
                resolve(at, Pool::textures, at.textures, index.texcoord_index,
                        corner);
            if (index.normal_index != 0)
                resolve(at, Pool::normals, at.normals, index.normal_index,
                        corner);
        }
        if (at.keyword == Keyword::f) {
            mesh_.faces.push_back(vertices_);
            return;
        }
        for (std::size_t k = 1; k < vertices_.size(); ++k)
            mesh_.loose_edges.push_back({vertices_[k - 1], vertices_[k]});
    }

    /// From the file's index (from 1, or from the end when negative) to ours.
    /// A vertex 0 has been complained of.
    int resolve(const Statement& at, Pool pool, int so_far, int index,
                int corner) {
        if (index > so_far) later_.push_back({at.line, corner, pool, index});
        if (index < -so_far)
            defects_.add(at.line,
                         fmt::format("corner {} is {}, but only {} {} come "
                                     "before it",
                                     corner, index, so_far, name(pool)));
        return index > 0 ? index - 1 : so_far + index;
    }

    void check_forward_references() {
        for (const auto& [line, corner, pool, index] : later_)
            if (index > count(pool))
                defects_.add(
                    line, fmt::format("corner {} is {}, but the file "
                                      "has {} {}",
                                      corner, index, count(pool), name(pool)));
    }

    FileDefects defects_;
    IndexedMesh mesh_;
    CheckedLines lines_;
    std::vector<int> vertices_;  ///< of a line
    std::vector<ForwardReference> later_;
};

}  // namespace

IndexedMesh read_obj(const std::filesystem::path& file) {
    return ObjMesh(file).read(file);
}

void write_obj(const std::filesystem::path& file, const IndexedMesh& mesh) {
    require_writable(mesh);
    std::string text;
    const auto out = std::back_inserter(text);
    for (const auto& [x, y, z] : mesh.positions)
        fmt::format_to(out, "v {} {} {}\n", x, y, z);
    for (const auto& face : mesh.faces) {
        text += 'f';
        for (const int v : face) fmt::format_to(out, " {}", v + 1);
        text += '\n';
    }
    for (const auto& [a, b] : mesh.loose_edges)
        fmt::format_to(out, "l {} {}\n", a + 1, b + 1);
    replace_text(file, text);
}

}  // namespace course
