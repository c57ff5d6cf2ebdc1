#include "course/report/escape.h"

#include <algorithm>
#include <array>

#include "course/report/text.h"

namespace course {

namespace {

/// As visible(), which takes long to look at each code: nearly all texts of a
/// report are plain.
std::string shown(std::string_view text) {
    const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
    });
    return is_plain ? std::string(text) : visible(text);
}

/// The characters that are the same in HTML.
constexpr std::array<bool, 256> plain_in_html = [] {
    std::array<bool, 256> plain{};
    constexpr std::string_view marks = "&<>\"'";
    for (std::size_t c = 0; c < plain.size(); ++c)
        plain[c] = c == '\n' || c == '\t' ||
                   (c >= ' ' && c <= '~' &&
                    marks.find(static_cast<char>(c)) == marks.npos);
    return plain;
}();

/// What stands for the character in HTML; empty when it stands for itself.
std::string_view entity(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return "";
    }
}

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
    for (const char c : shown(text)) {
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
    const auto is_plain = [](unsigned char c) { return plain_in_html[c]; };
    if (std::all_of(text.begin(), text.end(), is_plain))
        return std::string(text);
    std::string escaped;
    for (const char c : shown(text)) {
        const std::string_view instead = entity(c);
        if (instead.empty())
            escaped += c;
        else
            escaped += instead;
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
    return shown(text);
}

}  // namespace course
