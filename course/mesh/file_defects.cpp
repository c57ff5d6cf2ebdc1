// Defects of mesh files, and the work on their text.
#include "course/mesh/file_defects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <random>
#include <span>
#include <system_error>
#include <utility>

namespace course {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::string lines_of(const std::filesystem::path& file,
                     const std::vector<FileDefect>& defects) {
    std::string lines;
    for (const auto& [line, what] : defects) {
        if (!lines.empty()) lines += '\n';
        lines += line > 0 ? fmt::format("{}:{}: {}", file.string(), line, what)
                          : fmt::format("{}: {}", file.string(), what);
    }
    return lines;
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what,
                       std::error_code why) {
    throw MeshFileError(file,
                        {{0, fmt::format("{}: {}", what, why.message())}});
}

std::error_code last_error() {
    return {errno, std::generic_category()};
}

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
    std::filesystem::path name = file;
    name += fmt::format(".{:08x}.tmp", std::random_device()());
    return name;
}

std::error_code write_text(const std::filesystem::path& file,
                           std::string_view text) {
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (out) return {};
    return last_error();
}

std::string_view trimmed(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return line;
}

std::string_view without_mark(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    return text;
}

template <class Number>
std::from_chars_result parse(std::string_view word, Number& value) {
    return std::from_chars(word.data(), word.data() + word.size(), value);
}

bool is_whole(std::string_view word, std::from_chars_result result) {
    return result.ptr == word.data() + word.size();
}

void require_finite(Vec3 p, int v) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw std::invalid_argument(
            fmt::format("vertex {} is at ({}, {}, {}), expected finite numbers",
                        v, p.x, p.y, p.z));
}

void require_vertices(const IndexedMesh& mesh, std::span<const int> vertices,
                      const char* what, int number) {
    for (const int v : vertices)
        if (v < 0 || v >= mesh.vertex_count())
            throw std::invalid_argument(fmt::format(
                "{} {} names vertex {}, but the mesh has {} vertices, from 0",
                what, number, v, mesh.vertex_count()));
}

}  // namespace

MeshFileError::MeshFileError(const std::filesystem::path& file,
                             std::vector<FileDefect> defects)
    : std::runtime_error(lines_of(file, defects)),
      defects_(std::move(defects)) {}

void FileDefects::add(int line, std::string what) {
    // In a file that is no mesh at all every word may be one.
    constexpr std::size_t most = 1000;
    if (defects_.size() < most)
        defects_.push_back({line, std::move(what)});
    else
        ++left_out_;
}

void FileDefects::throw_if_any(const std::filesystem::path& file) {
    if (defects_.empty()) return;
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const FileDefect& a, const FileDefect& b) {
                         return a.line < b.line;
                     });
    if (left_out_ > 0)
        defects_.push_back({0, fmt::format("and {} more", left_out_)});
    throw MeshFileError(file, std::move(defects_));
}

void replace_text(const std::filesystem::path& file, std::string_view text) {
    const std::filesystem::path temporary = temporary_beside(file);
    std::error_code why = write_text(temporary, text);
    if (!why) std::filesystem::rename(temporary, file, why);
    if (!why) return;
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(file, "cannot be written", why);
}

void require_writable(const IndexedMesh& mesh) {
    for (int v = 0; v < mesh.vertex_count(); ++v)
        require_finite(mesh.positions[static_cast<std::size_t>(v)], v);
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face face = mesh.faces[f];
        if (face.size() < 3)
            throw std::invalid_argument(
                fmt::format("face {} has {}, expected at least 3", f,
                            counted(face.size(), "corner")));
        require_vertices(mesh, face, "face", f);
    }
    int e = 0;
    for (const std::array<int, 2>& edge : mesh.loose_edges)
        require_vertices(mesh, edge, "loose edge", e++);
}

Lines::Lines(std::string_view text) : rest_(without_mark(text)) {}

Lines::Lines(const std::filesystem::path& file)
    : file_(file), in_(file, std::ios::binary), is_all_(false) {
    if (!in_) fail(file_, "cannot be read", last_error());
    read_on();
    rest_ = without_mark(rest_);
}

/// More of the file after the rest; false when there is no more.
bool Lines::read_on() {
    if (is_all_) return false;
    constexpr std::size_t least = std::size_t{1} << 18;
    block_.erase(0, block_.size() - rest_.size());
    const std::size_t kept = block_.size();
    block_.resize(kept + std::max(kept, least));
    errno = 0;
    in_.read(block_.data() + kept,
             static_cast<std::streamsize>(block_.size() - kept));
    // Also for a directory, which can be opened like a file.
    if (in_.bad()) fail(file_, "cannot be read", last_error());
    is_all_ = in_.eof();
    block_.resize(kept + static_cast<std::size_t>(in_.gcount()));
    rest_ = block_;
    return true;
}

/// Of the rest; a CR at its end is one only when no LF can follow.
std::size_t Lines::end_of_line() {
    do {
        if (newline_ >= rest_.size() || rest_[newline_] != '\n')
            newline_ = std::min(rest_.find('\n', newline_), rest_.size());
        const std::size_t end =
            std::min(rest_.substr(0, newline_).find('\r'), newline_);
        if (end + 1 < rest_.size() || is_all_) return end;
    } while (read_on());
    return rest_.size();
}

bool Lines::next() {
    const std::size_t end = end_of_line();
    if (rest_.empty()) return false;
    line_ = rest_.substr(0, end);
    line_ = trimmed(line_.substr(0, line_.find('#')));
    const std::size_t after =
        std::min(rest_.size(), end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
    rest_.remove_prefix(after);
    newline_ = newline_ > after ? newline_ - after : 0;
    ++number_;
    return true;
}

void split(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (true) {
        while (at != end && is_blank(*at)) ++at;
        if (at == end) return;
        const char* const begin = at;
        while (at != end && !is_blank(*at)) ++at;
        words.emplace_back(begin, static_cast<std::size_t>(at - begin));
    }
}

std::string quoted(std::string_view word) {
    constexpr std::size_t most = 24;
    std::string text(word.substr(0, most));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return fmt::format("`{}{}`", text, word.size() > most ? "..." : "");
}

std::string counted(std::size_t n, const char* noun) {
    return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string read_number(std::string_view word, double& value) {
    std::string_view digits = word;
    if (word.starts_with('+') && !word.starts_with("+-"))
        digits.remove_prefix(1);
    const std::from_chars_result result = parse(digits, value);
    if (result.ec == std::errc::invalid_argument || !is_whole(digits, result))
        return fmt::format("{} is not a number", quoted(word));
    if (result.ec == std::errc::result_out_of_range)
        return fmt::format("{} is too large or too small for a number",
                           quoted(word));
    if (!std::isfinite(value))
        return fmt::format("{} is not a finite number", quoted(word));
    return {};
}

std::string read_integer(std::string_view word, int& value) {
    const std::from_chars_result result = parse(word, value);
    if (result.ec == std::errc::invalid_argument || !is_whole(word, result))
        return fmt::format("{} is not a whole number", quoted(word));
    if (result.ec == std::errc::result_out_of_range)
        return fmt::format("{} is too large for a whole number", quoted(word));
    return {};
}

}  // namespace course
