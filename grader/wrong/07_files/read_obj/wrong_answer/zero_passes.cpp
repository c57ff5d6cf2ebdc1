// Lets a corner be 0.
// Hint: You accept a corner that names no vertex.
#include "exercises/07_files/read_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace {

using Words = std::vector<std::string>;

/// A line with something on it.
struct Statement {
    int line;
    Words words;
};

const std::array passed_over = {"vt", "vn", "vp",     "p",     "g",
                                "o",  "s",  "usemtl", "mtllib"};

[[noreturn]] void fail(int line, const std::string& what) {
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

std::vector<Statement> statements(const std::string& text) {
    std::vector<Statement> found;
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream left(line.substr(0, line.find('#')));
        Words words(std::istream_iterator<std::string>(left), {});
        if (!words.empty()) found.push_back({number, words});
    }
    return found;
}

double number(int line, const std::string& word) {
    char* rest = nullptr;
    double value = std::strtod(word.c_str(), &rest);
    if (*rest != '\0') fail(line, word + " is not a number");
    if (!std::isfinite(value)) fail(line, word + " is not finite");
    return value;
}

Vec3 read_vertex(const Statement& v) {
    if (v.words.size() < 4) fail(v.line, "expected v x y z");
    return {number(v.line, v.words[1]), number(v.line, v.words[2]),
            number(v.line, v.words[3])};
}

/// The vertex that a corner names, from 0; `before` come before it in the
/// file, which has `all`.
int vertex(int line, const std::string& corner, int before, int all) {
    int value = 0;
    const std::string word = corner.substr(0, corner.find('/'));
    const char* end = word.data() + word.size();
    auto [rest, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || rest != end)
        fail(line, corner + " does not begin with a whole number");
    if (value > all || value < -before)
        fail(line, "there is no vertex " + word);
    return value > 0 ? value - 1 : before + value;
}

/// The vertices of an f or an l line, of which there must be `least`.
std::vector<int> read_corners(const Statement& s, std::size_t least, int before,
                              int all) {
    if (s.words.size() - 1 < least)
        fail(s.line, "expected at least " + std::to_string(least) + " corners");
    std::vector<int> corners;
    for (std::size_t k = 1; k < s.words.size(); ++k)
        corners.push_back(vertex(s.line, s.words[k], before, all));
    return corners;
}

void add_line(IndexedMesh& mesh, const std::vector<int>& corners) {
    for (std::size_t k = 1; k < corners.size(); ++k)
        mesh.loose_edges.push_back({corners[k - 1], corners[k]});
}

}  // namespace

IndexedMesh read_obj(const std::string& text) {
    const std::vector<Statement> all = statements(text);
    const int vertices = static_cast<int>(std::count_if(
        all.begin(), all.end(), [](auto& s) { return s.words[0] == "v"; }));

    IndexedMesh mesh;
    for (const Statement& s : all) {
        const std::string& keyword = s.words[0];
        int before = mesh.vertex_count();
        if (keyword == "v")
            mesh.positions.push_back(read_vertex(s));
        else if (keyword == "f")
            mesh.faces.push_back(read_corners(s, 3, before, vertices));
        else if (keyword == "l")
            add_line(mesh, read_corners(s, 2, before, vertices));
        else if (std::count(passed_over.begin(), passed_over.end(), keyword) ==
                 0)
            fail(s.line, keyword + " is no keyword known here");
    }
    return mesh;
}
