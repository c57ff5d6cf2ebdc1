// Meshes as texts.
#include "grader/suites/07_files/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

namespace course::hidden {

namespace {

std::string vertex_words(Vec3 p) {
    return fmt::format("{:.17g} {:.17g} {:.17g}", p.x, p.y, p.z);
}

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
    std::istringstream left(line.substr(0, line.find('#')));
    Words words;
    for (std::string word; left >> word;) words.push_back(word);
    return words;
}

/// The words of each line that has some.
std::vector<Words> statements_of(const std::string& text) {
    std::vector<Words> statements;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (Words words = words_of(line); !words.empty())
            statements.push_back(std::move(words));
    return statements;
}

[[noreturn]] void refuse(const std::string& why) {
    throw std::invalid_argument(why);
}

double number(const std::string& word) {
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    if (word.find_first_not_of("+-.0123456789eE") != std::string::npos ||
        *rest != '\0' || !std::isfinite(value))
        refuse("`" + word.substr(0, 24) + "` is not a finite decimal number");
    return value;
}

/// A whole number from `least` up to below `end`.
int whole(const std::string& word, int least, int end) {
    int value = 0;
    const char* const last = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), last, value);
    if (error != std::errc() || rest != last || value < least || value >= end)
        refuse(fmt::format("`{}` is not a whole number from {} to {}",
                           word.substr(0, 24), least, end - 1));
    return value;
}

constexpr int any_count = 1 << 30;

Vec3 position(const Words& words, std::size_t first) {
    if (words.size() != first + 3)
        refuse(fmt::format("a vertex line has {} words", words.size()));
    return {number(words[first]), number(words[first + 1]),
            number(words[first + 2])};
}

/// The words from the second one on as vertices, which begin at `first`.
std::vector<int> vertices(const Words& words, int first, int count) {
    std::vector<int> list;
    for (std::size_t k = 1; k < words.size(); ++k)
        list.push_back(whole(words[k], first, first + count) - first);
    return list;
}

IndexedMesh off_mesh(const std::vector<Words>& lines) {
    if (lines.size() < 2 || lines[0] != Words{"OFF"} || lines[1].size() != 3)
        refuse("expected OFF and a line of three counts");
    const int n = whole(lines[1][0], 0, any_count);
    const int faces = whole(lines[1][1], 0, any_count);
    whole(lines[1][2], 0, any_count);
    if (lines.size() !=
        2 + static_cast<std::size_t>(n) + static_cast<std::size_t>(faces))
        refuse(
            fmt::format("{} vertices and {} faces, but {} lines after the "
                        "counts",
                        n, faces, lines.size() - 2));
    IndexedMesh mesh;
    for (std::size_t k = 2; k < lines.size(); ++k) {
        if (mesh.vertex_count() < n) {
            mesh.positions.push_back(position(lines[k], 0));
            continue;
        }
        const std::vector<int> face = vertices(lines[k], 0, n);
        if (whole(lines[k][0], 3, any_count) != static_cast<int>(face.size()))
            refuse("a face line with another number of corners than it says");
        mesh.faces.push_back(face);
    }
    return mesh;
}

void add_obj_statement(IndexedMesh& mesh, const Words& words) {
    const std::string& keyword = words[0];
    if (keyword == "v" && mesh.faces.empty() && mesh.loose_edges.empty()) {
        mesh.positions.push_back(position(words, 1));
    } else if (keyword == "f" && mesh.loose_edges.empty()) {
        const std::vector<int> face = vertices(words, 1, mesh.vertex_count());
        if (face.size() < 3) refuse("an f line with fewer than three corners");
        mesh.faces.push_back(face);
    } else if (keyword == "l") {
        const std::vector<int> edge = vertices(words, 1, mesh.vertex_count());
        if (edge.size() != 2) refuse("an l line without two vertices");
        mesh.loose_edges.push_back({edge[0], edge[1]});
    } else {
        refuse("a line begins with `" + keyword.substr(0, 24) +
               "`, expected v, then f, then l");
    }
}

IndexedMesh obj_mesh(const std::vector<Words>& lines) {
    IndexedMesh mesh;
    for (const Words& words : lines) add_obj_statement(mesh, words);
    return mesh;
}

template <class Parse>
ReadBack read_back(const std::string& text, Parse parse) {
    try {
        return {parse(statements_of(text)), ""};
    } catch (const std::invalid_argument& error) {
        return {{}, error.what()};
    }
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string position_difference(const IndexedMesh& got,
                                const IndexedMesh& wanted) {
    for (std::size_t v = 0; v < wanted.positions.size(); ++v) {
        const Vec3 a = got.positions[v];
        const Vec3 b = wanted.positions[v];
        if (!same_bits(a.x, b.x) || !same_bits(a.y, b.y) ||
            !same_bits(a.z, b.z))
            return fmt::format("vertex {} is at {}, expected {}", v,
                               vertex_words(a), vertex_words(b));
    }
    return "";
}

std::string corners(FaceList::Face face) {
    return show(std::vector<int>(face.begin(), face.end()));
}

using Random = std::mt19937_64;

std::uint64_t below(Random& random, std::uint64_t n) {
    return random() % n;
}

/// A number that is not short in decimals, between 1e-250 and 1e250.
double awkward(Random& random) {
    const double digits = static_cast<double>(random() >> 11);
    // Mostly near 1, now and then very large or small.
    const int range = below(random, 3) == 0 ? 780 : 20;
    const int exponent = static_cast<int>(below(random, 2U * 780U)) - 780;
    const double size = std::ldexp(digits, exponent % range - 52);
    return below(random, 2) == 0 ? size : -size;
}

std::string pick(Random& random, const TextLines& choice) {
    return choice[below(random, choice.size())];
}

}  // namespace

TextLines off_lines(const IndexedMesh& mesh) {
    TextLines lines{
        "OFF", fmt::format("{} {} 0", mesh.vertex_count(), mesh.faces.size())};
    for (const Vec3 p : mesh.positions) lines.push_back(vertex_words(p));
    for (const FaceList::Face face : mesh.faces) {
        lines.push_back(std::to_string(face.size()));
        for (const int v : face) lines.back() += " " + std::to_string(v);
    }
    return lines;
}

TextLines obj_lines(const IndexedMesh& mesh) {
    TextLines lines;
    for (const Vec3 p : mesh.positions) lines.push_back("v " + vertex_words(p));
    for (const FaceList::Face face : mesh.faces) {
        lines.push_back("f");
        for (const int v : face) lines.back() += " " + std::to_string(v + 1);
    }
    for (const auto& [a, b] : mesh.loose_edges)
        lines.push_back(fmt::format("l {} {}", a + 1, b + 1));
    return lines;
}

std::string joined(const TextLines& lines, const std::string& end) {
    std::string text;
    for (const std::string& line : lines) text += line + end;
    return text;
}

Decorated decorated(const TextLines& lines, std::uint64_t salt) {
    Random random(seed() * 1000 + salt);
    const std::string end = pick(random, {"\n", "\r\n"});
    const TextLines between{"", " ", "\t", "# 3 0 1 2", "#", "  # v 1 2 3"};
    const TextLines behind{"", "", " ", "\t", " # 7", "#", "# f 1 2 3 # 4"};
    Decorated result;
    int number = 0;
    for (const std::string& line : lines) {
        while (below(random, 3) == 0) {
            result.text += pick(random, between) + end;
            ++number;
        }
        result.number.push_back(++number);
        std::string spaced = pick(random, {"", "", " ", "\t", "   "});
        for (const char c : line)
            spaced += c == ' ' ? pick(random, {" ", " ", "  ", "\t", " \t "})
                               : std::string(1, c);
        result.text += spaced + pick(random, behind) + end;
    }
    result.text += pick(random, {"", " ", end, "# the end", " " + end + end});
    return result;
}

ReadBack off_read_back(const std::string& text) {
    return read_back(text, off_mesh);
}

ReadBack obj_read_back(const std::string& text) {
    return read_back(text, obj_mesh);
}

std::string mesh_difference(const IndexedMesh& got, const IndexedMesh& wanted) {
    if (got.vertex_count() != wanted.vertex_count())
        return fmt::format("{} vertices, expected {}", got.vertex_count(),
                           wanted.vertex_count());
    std::string wrong = position_difference(got, wanted);
    if (!wrong.empty()) return wrong;
    if (got.faces.size() != wanted.faces.size())
        return fmt::format("{} faces, expected {}", got.faces.size(),
                           wanted.faces.size());
    for (int f = 0; f < wanted.faces.size(); ++f)
        if (!std::ranges::equal(got.faces[f], wanted.faces[f]))
            return fmt::format("face {} is {}, expected {}", f,
                               corners(got.faces[f]), corners(wanted.faces[f]));
    if (got.loose_edges != wanted.loose_edges)
        return fmt::format("the loose edges are {}, expected {}",
                           show(got.loose_edges), show(wanted.loose_edges));
    return "";
}

int named_line(const std::string& message) {
    constexpr std::string_view begin = "line ";
    if (!message.starts_with(begin)) return -1;
    int line = -1;
    const char* const last = message.data() + message.size();
    const auto [rest, error] =
        std::from_chars(message.data() + begin.size(), last, line);
    const std::string_view left(rest, static_cast<std::size_t>(last - rest));
    return error == std::errc() && left.starts_with(": ") ? line : -1;
}

IndexedMesh with_awkward_positions(IndexedMesh mesh, std::uint64_t salt) {
    Random random(seed() * 1000 + salt);
    for (Vec3& p : mesh.positions)
        p = {awkward(random), awkward(random), awkward(random)};
    return mesh;
}

std::vector<Fixture> file_meshes() {
    std::vector<Fixture> fixtures = made_by_hand();
    for (Fixture& fixture : generated_fixtures())
        fixtures.push_back(std::move(fixture));
    for (const Fixture& fixture :
         {zoo::fan3(), zoo::house_with_wall(), zoo::moebius5(),
          polygons({3, 12, 4, 300, 5, 256}), polygons({})})
        fixtures.push_back(fixture);
    return fixtures;
}

std::vector<Fixture> without_loose_edges(std::vector<Fixture> fixtures) {
    for (Fixture& fixture : fixtures) fixture.mesh.loose_edges.clear();
    return fixtures;
}

Fixture polygons(const std::vector<int>& sides) {
    Fixture fixture;
    fixture.name = "polygons";
    IndexedMesh& mesh = fixture.mesh;
    double x = 0;
    for (const int n : sides) {
        std::vector<int> face;
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * 3.14159265358979 * k / n;
            face.push_back(mesh.vertex_count());
            mesh.positions.push_back({x + std::cos(angle), std::sin(angle), 0});
        }
        mesh.faces.push_back(face);
        x += 3;
    }
    return fixture;
}

}  // namespace course::hidden
