#include "grader/pipeline/submitted_names.h"

#include <algorithm>
#include <array>

#include "course/mesh/ascii.h"
#include "course/runner/nearest.h"

namespace grader {

namespace {

bool strip_suffix(std::string& text, std::string_view suffix) {
    if (!text.ends_with(suffix)) return false;
    text.resize(text.size() - suffix.size());
    return true;
}

/// "face_sides" of "Face-Sides (1).cpp.txt": what a copy, a browser or a file
/// manager adds is taken away.
std::string bare_stem(std::string_view file_name) {
    std::string stem =
        course::ascii_lower(file_name.substr(0, file_name.find('.')));
    for (char& c : stem)
        if (c == ' ' || c == '-') c = '_';
    strip_suffix(stem, "copy");
    strip_suffix(stem, "copia");
    strip_suffix(stem, ")");
    while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9')
        stem.pop_back();
    strip_suffix(stem, "(");
    while (strip_suffix(stem, "_")) continue;
    return stem;
}

/// A header or a note beside the file is no mistake.
bool is_companion(std::string_view file_name) {
    constexpr std::array<std::string_view, 4> ends = {".h", ".hpp", ".md",
                                                      ".o"};
    return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) {
        return file_name.ends_with(end);
    });
}

}  // namespace

bool is_left_behind(std::string_view name) {
    return name.starts_with('.') || name == "__MACOSX";
}

std::optional<std::string> meant_by(
    std::string_view name, const std::vector<std::string>& file_names) {
    if (is_companion(name)) return std::nullopt;
    const std::string stem = bare_stem(name);
    std::optional<std::string> best;
    std::size_t least = 3;  // two letters wrong, and one at a third of the name
    for (const std::string& wanted : file_names) {
        const std::string right = bare_stem(wanted);
        const std::size_t distance = course::edit_distance(stem, right);
        if (distance >= least || 3 * distance > right.size()) continue;
        best = wanted;
        least = distance;
    }
    return best;
}

}  // namespace grader
