#include "grader/pipeline/leaks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "course/runner/exercises.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t by_accident = 40;  ///< a shorter line says nothing
constexpr std::size_t name_alone = 20, name_in_prose = 48;

/// Of this tree, what never leaves it.
constexpr std::array<const char*, 2> withheld = {"solutions", "grader"};

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == line.npos) return "";
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

std::set<std::string> lines_of(const fs::path& file) {
    std::set<std::string> lines;
    std::istringstream in(course::read_file(file));
    for (std::string line; std::getline(in, line);) lines.insert(trimmed(line));
    return lines;
}

/// The lines, and those that begin the definition of what they declare.
std::set<std::string> with_heads(std::set<std::string> lines) {
    for (const std::string& line : std::set<std::string>(lines))
        if (line.ends_with(';'))
            lines.insert(line.substr(0, line.size() - 1) + " {");
    return lines;
}

/// Whether anyone writes this line who has such data: it gives nothing away.
bool is_idiom(const std::string& line) {
    static const std::set<std::string> idioms = {
        "std::vector<int> corners(face.begin(), face.end());",
        "std::min_element(corners.begin(), corners.end()),",
        R"(std::rotate(face.begin(), std::min_element(face.begin(), face.end()),)",
        "const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];",
        "std::istringstream left(line.substr(0, line.find('#')));",
    };
    return line.starts_with("for (") || idioms.contains(line);
}

/// The course checks its own tables: what the exercise validate asks for cannot
/// be kept from who looks for it there.
bool may_have_lines(const std::string& file) {
    return file == "course/halfedge/validate.cpp";
}

/// Files below a folder, relative to it, in order.
std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory())
            files.push_back(entry.path().lexically_relative(folder).string());
    std::sort(files.begin(), files.end());
    return files;
}

/// A text without what line breaks do to it: blanks become one, and two
/// literals beside each other become one, too.
struct Flat {
    std::string text;
    std::vector<int> line;  ///< of each character
};

Flat flat(std::string_view text) {
    Flat result;
    int line = 1;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!is_blank || (!result.text.empty() && result.text.back() != ' ')) {
            result.text += is_blank ? ' ' : c;
            result.line.push_back(line);
        }
        if (c == '\n') ++line;
        if (result.text.ends_with("\" \"") && result.text.size() > 3) {
            result.text.resize(result.text.size() - 3);
            result.line.resize(result.text.size());
        }
    }
    return result;
}

/// Whether the part stands alone: in quotes, between tags, behind a colon.
bool stands_alone(std::string_view text, std::size_t at, std::size_t size) {
    const std::string_view before = text.substr(0, at);
    const std::string_view after = text.substr(at + size);
    constexpr std::string_view opening = "\"'`>", closing = "\"'`<";
    const bool begins =
        before.ends_with(": ") ||
        (!before.empty() && opening.find(before.back()) != opening.npos);
    return begins && !after.empty() &&
           closing.find(after.front()) != closing.npos;
}

/// A text to be found in many others.
struct Secret {
    explicit Secret(std::string said, std::string of)
        : text(std::make_unique<std::string>(std::move(said))),
          what(std::move(of)),
          search(text->begin(), text->end()) {}

    std::unique_ptr<std::string> text;
    std::string what;
    std::boyer_moore_horspool_searcher<std::string::iterator> search;

    /// Where it stands at or behind `from`; nothing where it does not.
    std::optional<std::size_t> in(const std::string& other,
                                  std::size_t from) const {
        const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
        const auto found = std::search(begin, other.end(), search);
        if (found == other.end()) return std::nullopt;
        return static_cast<std::size_t>(found - other.begin());
    }
};

/// All that may not stand in a copy.
class Secrets {
public:
    Secrets() {
        for (const std::string& line : secret_lines())
            lines_.emplace_back(line, "a line of a reference: " + line);
        add_names();
        for (const char* folder : withheld) add_files(folder);
    }

    void look_at(const std::string& file, const std::string& bytes,
                 std::vector<Leak>& leaks) const {
        look_at_place(file, bytes, leaks);
        if (!may_have_lines(file)) look_for_lines(file, bytes, leaks);
        look_for_names(file, bytes, leaks);
    }

private:
    void add_names() {
        const fs::path suites = course::source_root() / "grader" / "suites";
        std::set<std::string> seen;
        for (const std::string& file : files_below(suites))
            for (const std::string& name :
                 case_names(course::read_file(suites / file)))
                if (name.size() >= name_alone && seen.insert(name).second)
                    names_.emplace_back(
                        name, fmt::format("the name of a hidden case of {}: {}",
                                          file, name));
    }

    void add_files(const std::string& folder) {
        const fs::path root = course::source_root();
        if (!fs::is_directory(root / folder)) return;
        for (const std::string& file : files_below(root / folder)) {
            std::string bytes = course::read_file(root / folder / file);
            if (!bytes.empty())
                files_.emplace(std::move(bytes),
                               fmt::format("{}/{}", folder, file));
        }
    }

    void look_at_place(const std::string& file, const std::string& bytes,
                       std::vector<Leak>& leaks) const {
        for (const fs::path& part : fs::path(file))
            for (const char* folder : withheld)
                if (part == folder)
                    leaks.push_back(
                        {file, 0, fmt::format("a file of {}/", folder)});
        if (const auto same = files_.find(bytes); same != files_.end())
            leaks.push_back({file, 0, "the same as " + same->second});
    }

    void look_for_lines(const std::string& file, const std::string& bytes,
                        std::vector<Leak>& leaks) const {
        for (const Secret& line : lines_)
            if (const auto at = line.in(bytes, 0)) {
                const auto end =
                    bytes.begin() + static_cast<std::ptrdiff_t>(*at);
                const auto before = std::count(bytes.begin(), end, '\n');
                leaks.push_back(
                    {file, static_cast<int>(before) + 1, line.what});
            }
    }

    void look_for_names(const std::string& file, const std::string& bytes,
                        std::vector<Leak>& leaks) const {
        const Flat text = flat(bytes);
        for (const Secret& name : names_) {
            const std::size_t size = name.text->size();
            for (auto at = name.in(text.text, 0); at;
                 at = name.in(text.text, *at + 1)) {
                if (size < name_in_prose && !stands_alone(text.text, *at, size))
                    continue;
                leaks.push_back({file, text.line[*at], name.what});
                break;
            }
        }
    }

    std::vector<Secret> lines_, names_;
    std::map<std::string, std::string> files_;  ///< bytes, and where they are
};

}  // namespace

std::string text_of(const Leak& leak) {
    const std::string line =
        leak.line > 0 ? ":" + std::to_string(leak.line) : "";
    return fmt::format("{}{}: {}", leak.file, line, leak.what);
}

std::set<std::string> secret_lines() {
    std::set<std::string> secret;
    for (const course::Exercise& exercise : course::all_exercises()) {
        const auto given = with_heads(lines_of(exercise.contract()));
        const auto skeleton = lines_of(exercise.skeleton());
        for (const std::string& line : lines_of(exercise.solution()))
            if (line.size() > by_accident && !is_idiom(line) &&
                !given.contains(line) && !skeleton.contains(line))
                secret.insert(line);
    }
    return secret;
}

std::vector<std::string> case_names(std::string_view suite) {
    std::vector<std::string> names;
    const Flat text = flat(suite);
    const std::string begin = "TEST_CASE(";
    for (auto at = text.text.find(begin); at != std::string::npos;
         at = text.text.find(begin, at)) {
        at = text.text.find('"', at);
        if (at == std::string::npos) break;
        ++at;
        std::string name;
        for (; at < text.text.size() && text.text[at] != '"'; ++at) {
            if (text.text[at] == '\\') ++at;
            if (at < text.text.size()) name += text.text[at];
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::vector<Leak> leaks_in(const fs::path& copy) {
    const Secrets secrets;
    std::vector<Leak> leaks;
    for (const std::string& file : files_below(copy))
        secrets.look_at(file, course::read_file(copy / file), leaks);
    return leaks;
}

}  // namespace grader
