// Looks only at the very next line for something after the last face.
// Hint: You do not look at everything that follows the last face.
#include "exercises/07_files/read_off.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace {

[[noreturn]] void fail(int line, const std::string& what) {
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

/// Where the reader is: the words of a line that has some.
struct Source {
    std::istringstream text;
    int line = 0;
    std::vector<std::string> words;
};

/// Goes to the next line with something on it; false at the end.
bool next_line(Source& in) {
    std::string line;
    while (std::getline(in.text, line)) {
        ++in.line;
        std::istringstream left(line.substr(0, line.find('#')));
        in.words.assign(std::istream_iterator<std::string>(left), {});
        if (!in.words.empty()) return true;
    }
    return false;
}

void require_line(Source& in, const std::string& what) {
    if (!next_line(in)) fail(in.line, "the text ends, expected " + what);
}

int whole_number(int line, const std::string& word) {
    int value = 0;
    const char* end = word.data() + word.size();
    auto [rest, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || rest != end)
        fail(line, word + " is not a whole number");
    return value;
}

double number(int line, const std::string& word) {
    char* rest = nullptr;
    double value = std::strtod(word.c_str(), &rest);
    if (*rest != '\0') fail(line, word + " is not a number");
    if (!std::isfinite(value)) fail(line, word + " is not finite");
    return value;
}

struct Counts {
    int vertices, faces;
};

Counts read_header(Source& in) {
    require_line(in, "OFF");
    if (in.words[0] != "OFF") fail(in.line, "expected OFF");
    if (in.words.size() > 1)
        in.words.erase(in.words.begin());
    else
        require_line(in, "three counts");
    if (in.words.size() != 3) fail(in.line, "expected three counts");
    for (const std::string& word : in.words)
        if (whole_number(in.line, word) < 0)
            fail(in.line, "the count " + word + " is negative");
    return {whole_number(in.line, in.words[0]),
            whole_number(in.line, in.words[1])};
}

Vec3 read_vertex(Source& in) {
    require_line(in, "a vertex");
    if (in.words.size() != 3) fail(in.line, "expected x y z");
    return {number(in.line, in.words[0]), number(in.line, in.words[1]),
            number(in.line, in.words[2])};
}

std::vector<int> read_face(Source& in, int vertices) {
    require_line(in, "a face");
    int n = whole_number(in.line, in.words[0]);
    if (n < 3) fail(in.line, "a face has at least 3 corners");
    if (in.words.size() - 1 < static_cast<std::size_t>(n))
        fail(in.line, "expected " + std::to_string(n) + " corners");
    std::vector<int> face;
    for (int k = 1; k <= n; ++k) {
        const std::string& word = in.words[static_cast<std::size_t>(k)];
        int v = whole_number(in.line, word);
        if (v < 0 || v >= vertices) fail(in.line, "there is no vertex " + word);
        face.push_back(v);
    }
    return face;
}

}  // namespace

IndexedMesh read_off(const std::string& text) {
    Source in;
    in.text.str(text);
    Counts counts = read_header(in);

    IndexedMesh mesh;
    for (int v = 0; v < counts.vertices; ++v)
        mesh.positions.push_back(read_vertex(in));
    for (int f = 0; f < counts.faces; ++f)
        mesh.faces.push_back(read_face(in, counts.vertices));
    std::string line;
    std::getline(in.text, line);
    if (line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#')
        fail(in.line + 1, "expected nothing after the last face");
    return mesh;
}
