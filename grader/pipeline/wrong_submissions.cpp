#include "grader/pipeline/wrong_submissions.h"

#include <algorithm>

namespace grader {

namespace {

namespace fs = std::filesystem;

/// The text of a comment's line; `line` becomes empty when it is none.
bool take_comment(std::string_view& line) {
    const std::size_t mark =
        line.starts_with("//") ? 2u : (line.starts_with('#') ? 1u : 0u);
    if (mark == 0 || line.starts_with("#include")) return false;
    line.remove_prefix(mark);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    return true;
}

}  // namespace

WrongSubmissions wrong_submissions(const course::Exercise& exercise) {
    WrongSubmissions found;
    const fs::path folder = course::source_root() / "grader" / "wrong" /
                            exercise.topic / exercise.name;
    if (!fs::exists(folder)) return found;
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const auto verdict =
            course::verdict_named(file.parent_path().filename().string());
        if (verdict && file.extension() == exercise.skeleton().extension())
            found.all.push_back({file, *verdict});
        else
            found.strays.push_back(file);
    }
    return found;
}

MistakeText mistake_text(std::string_view source) {
    constexpr std::string_view hint = "Hint:";
    MistakeText text;
    std::string* part = &text.mistake;
    while (!source.empty()) {
        const std::size_t end = std::min(source.find('\n'), source.size());
        std::string_view line = source.substr(0, end);
        source.remove_prefix(std::min(end + 1, source.size()));
        if (!take_comment(line)) break;
        if (line.starts_with(hint)) {
            part = &text.hint;
            line.remove_prefix(std::min(hint.size() + 1, line.size()));
        }
        if (!part->empty()) *part += ' ';
        *part += line;
    }
    return text;
}

}  // namespace grader
