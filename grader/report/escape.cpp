#include "grader/report/escape.h"

#include <algorithm>
#include <array>

#include "course/report/text.h"

namespace grader {

namespace {

/// Whether a spreadsheet may take the field for a formula: by its first
/// character, blanks apart, the wide forms of which some count as well.
bool looks_like_formula(std::string_view text) {
    constexpr std::array<std::string_view, 8> signs = {
        "=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return std::any_of(signs.begin(), signs.end(), [&](std::string_view sign) {
        return text.starts_with(sign);
    });
}

std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : course::visible(text)) {
        if (c == '\n')
            line += "\\n";
        else if (c == '\t')
            line += "\\t";
        else
            line += c;
    }
    return line;
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string escaped;
    for (const char c : course::visible(text)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string escape_xml(std::string_view text) {
    // What visible() spells out includes all that XML forbids, and '>' is
    // escaped, so that "]]>" cannot end anything.
    return escape_html(text);
}

std::string escape_csv(std::string_view text) {
    std::string field = on_one_line(text);
    if (looks_like_formula(field)) field.insert(0, "'");
    const bool plain = field.find_first_of(",;\"'") == field.npos &&
                       !field.starts_with(' ') && !field.ends_with(' ');
    if (plain) return field;
    std::string quoted = "\"";
    for (const char c : field) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string escape_terminal(std::string_view text) {
    return on_one_line(text);
}

std::string escape_json(std::string_view text) {
    return course::visible(text);
}

}  // namespace grader
