#include "course/runner/statement.h"

#include <sstream>

namespace course {

namespace {

constexpr std::string_view italian_mark = "\n<!-- it -->\n";

std::string_view heading_of_hints(Language language) {
    return language == Language::italian ? "## Suggerimenti" : "## Hints";
}

bool starts_an_item(const std::string& line) {
    const auto digits = line.find_first_not_of("0123456789");
    return digits != 0 && digits != std::string::npos && line[digits] == '.';
}

/// The numbered items behind the first line, up to the next heading.
std::vector<std::string> items_of(const std::string& section) {
    std::vector<std::string> items;
    std::istringstream lines(section);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.rfind("## ", 0) != 0) {
        const auto first = line.find_first_not_of(" \t");
        if (starts_an_item(line))
            items.push_back(line.substr(line.find('.') + 2));
        else if (!items.empty() && first != std::string::npos)
            items.back() += " " + line.substr(first);
    }
    return items;
}

}  // namespace

std::optional<Language> language_named(std::string_view name) {
    const std::string_view first = name.substr(0, 2);
    if (name.size() > 2 && name[2] != '_' && name[2] != '.') return {};
    if (first == "it") return Language::italian;
    if (first == "en" || name == "C" || name == "POSIX")
        return Language::english;
    return std::nullopt;
}

std::string part_in(std::string_view file, Language language) {
    const auto mark = file.find(italian_mark);
    if (language == Language::english) return std::string(file.substr(0, mark));
    if (mark == file.npos) return "";
    const auto begin = file.find('#', mark + italian_mark.size());
    return begin == file.npos ? "" : std::string(file.substr(begin));
}

Statement statement_in(std::string_view file, Language wanted) {
    std::string text = part_in(file, wanted);
    if (text.empty()) text = part_in(file, wanted = Language::english);
    Statement statement;
    statement.language = wanted;
    const auto start = text.find_first_not_of("# ");
    if (start != text.npos)
        statement.title = text.substr(start, text.find('\n', start) - start);
    const auto hints = text.find(heading_of_hints(wanted));
    if (hints != text.npos) statement.hints = items_of(text.substr(hints));
    statement.text = text.substr(0, hints);
    return statement;
}

Statement statement_of(const Exercise& exercise, Language wanted) {
    return statement_in(read_file(exercise.statement()), wanted);
}

}  // namespace course
