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
// So it gets only lines that hold nothing of this, by the interface that counts
// sides as int. That one has no callback for `l` lines; they are handed on as
// `f` lines, since the indices of both are written alike.
#include "course/mesh/obj.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <istream>
#include <iterator>
#include <span>
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

/// The v, f and l lines of a file, one at a time, as tinyobjloader may see
/// them. It asks for the next line only when it is done with the one before,
/// so its callbacks find here what else is to be known of their line.
class CheckedLines : public std::streambuf {
public:
    CheckedLines(std::string_view text, FileDefects& defects)
        : lines_(text), defects_(defects) {}

    int line() const { return line_; }
    Keyword keyword() const { return keyword_; }
    /// The vertex of a v line, which tinyobjloader would round.
    Vec3 position() const { return position_; }
    int textures() const { return textures_; }
    int normals() const { return normals_; }

protected:
    int_type underflow() override {
        do {
            if (!next_statement()) return traits_type::eof();
        } while (!check());
        statement_ += '\n';
        setg(statement_.data(), statement_.data(),
             statement_.data() + statement_.size());
        return traits_type::to_int_type(statement_.front());
    }

private:
    /// Joins lines that end in a backslash; false at the end of the file.
    bool next_statement() {
        if (!lines_.next()) return false;
        line_ = lines_.number();
        statement_ = lines_.line();
        while (statement_.ends_with('\\')) {
            statement_.back() = ' ';
            if (lines_.next())
                statement_ += lines_.line();
            else
                defects_.add(line_, "the file ends after a `\\`");
        }
        return true;
    }

    /// Whether tinyobjloader is to see the statement; reports its defects.
    bool check() {
        std::vector<std::string_view> words = words_of(statement_);
        if (words.empty()) return false;
        const std::string_view word = words.front();
        words.erase(words.begin());
        if (word == "v")
            check_vertex(words);
        else if (word == "f")
            check_indices(Keyword::f, words);
        else if (word == "l")
            check_indices(Keyword::l, words);
        else
            return check_other(word);
        return true;
    }

    /// Always false: tinyobjloader has nothing to do with it.
    bool check_other(std::string_view word) {
        if (word == "vt")
            ++textures_;
        else if (word == "vn")
            ++normals_;
        else if (std::find(passed_over.begin(), passed_over.end(), word) ==
                 passed_over.end())
            defects_.add(line_, fmt::format("{} is no keyword known here",
                                            quoted(word)));
        return false;
    }

    /// A bad vertex counts as one, for the sake of the indices after it.
    void check_vertex(const std::vector<std::string_view>& words) {
        keyword_ = Keyword::v;
        std::array<double, 7> numbers{};
        const std::size_t n = words.size();
        if (n != 3 && n != 4 && n != 6 && n != 7)
            defects_.add(line_, fmt::format("v has {}, expected x y z (then "
                                            "perhaps w, or a colour)",
                                            counted(n, "number")));
        for (std::size_t k = 0; k < std::min(n, numbers.size()); ++k)
            if (std::string wrong = read_number(words[k], numbers[k]);
                !wrong.empty())
                defects_.add(line_, fmt::format("v: {}", wrong));
        position_ = {numbers[0], numbers[1], numbers[2]};
        statement_ = "v 0 0 0";
    }

    /// What is bad goes on as index 0, which means none, so that the others of
    /// the line are looked at.
    void check_indices(Keyword keyword,
                       const std::vector<std::string_view>& words) {
        keyword_ = keyword;
        const char* const name = keyword == Keyword::f ? "f" : "l";
        const std::size_t least = keyword == Keyword::f ? 3 : 2;
        if (words.size() < least)
            defects_.add(line_,
                         fmt::format("{} has {}, expected at least {}", name,
                                     counted(words.size(), "corner"), least));
        std::string checked = "f";
        for (std::size_t k = 0; k < words.size(); ++k) {
            const std::string wrong = index_defect(words[k]);
            checked += ' ';
            checked += wrong.empty() ? words[k] : "0";
            if (!wrong.empty())
                defects_.add(line_, fmt::format("{}: corner {}: {}", name,
                                                k + 1, wrong));
        }
        statement_ = std::move(checked);
    }

    Lines lines_;
    FileDefects& defects_;
    std::string statement_;
    int line_ = 0;
    Keyword keyword_ = Keyword::v;
    Vec3 position_;
    int textures_ = 0;
    int normals_ = 0;
};

/// Takes what tinyobjloader finds and makes a mesh of it.
class ObjMesh {
public:
    explicit ObjMesh(std::string_view text) : lines_(text, defects_) {}

    IndexedMesh read(const std::filesystem::path& file) && {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, auto...) {
            static_cast<ObjMesh*>(self)->add_vertex();
        };
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

    void add_vertex() { mesh_.positions.push_back(lines_.position()); }

    void add_indices(std::span<const tinyobj::index_t> indices) {
        std::vector<int> vertices;
        for (const tinyobj::index_t& index : indices) {
            const int corner = static_cast<int>(vertices.size()) + 1;
            vertices.push_back(
                resolve(Pool::vertices, index.vertex_index, corner));
            resolve(Pool::textures, index.texcoord_index, corner);
            resolve(Pool::normals, index.normal_index, corner);
        }
        if (lines_.keyword() == Keyword::f) {
            mesh_.faces.push_back(vertices);
            return;
        }
        for (std::size_t k = 1; k < vertices.size(); ++k)
            mesh_.loose_edges.push_back({vertices[k - 1], vertices[k]});
    }

    /// From the file's index (from 1, or from the end when negative) to ours.
    /// 0 stands for an index that is not given.
    int resolve(Pool pool, int index, int corner) {
        const int so_far = count(pool);
        if (index > so_far)
            later_.push_back({lines_.line(), corner, pool, index});
        if (index < -so_far)
            defects_.add(lines_.line(),
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
    CheckedLines lines_;
    IndexedMesh mesh_;
    std::vector<ForwardReference> later_;
};

}  // namespace

IndexedMesh read_obj(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    return ObjMesh(text).read(file);
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
