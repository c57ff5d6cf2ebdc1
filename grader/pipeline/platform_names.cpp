#include "grader/pipeline/platform_names.h"

#include <algorithm>
#include <array>

#include "course/mesh/ascii.h"

namespace grader {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Takes what stands at the begin of `text` as long as it `is` so.
template <class Is>
std::string_view take_while(std::string_view& text, Is is) {
    const auto end = std::find_if_not(text.begin(), text.end(), is);
    const std::string_view taken =
        text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(taken.size());
    return taken;
}

bool take(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

bool equal_in_small(std::string_view a, std::string_view b) {
    return course::ascii_lower(a) == course::ascii_lower(b);
}

// ---- Moodle

/// What follows "assignsubmission_": "file", "file_prev.cpp", "onlinetext_".
bool take_kind(std::string_view rest, PlatformName& name) {
    name.kind = take_while(rest, is_letter);
    if (name.kind.empty() || (!rest.empty() && !take(rest, "_"))) return false;
    name.file = rest;
    return true;
}

/// The name whose person ends before that underscore.
std::optional<PlatformName> moodle_at(std::string_view entry,
                                      std::size_t underscore) {
    PlatformName name;
    std::string_view rest = entry.substr(underscore + 1);
    name.key = take_while(rest, is_digit);
    if (!name.key.empty() && !take(rest, "_")) return std::nullopt;
    if (!take(rest, "assignsubmission_") || !take_kind(rest, name))
        return std::nullopt;
    name.person = entry.substr(0, underscore);
    // The worksheet calls them so; alone the word would be everybody's name.
    if (name.person == "Participant" && !name.key.empty())
        name.person += " " + name.key;
    return name;
}

// ---- Canvas

/// Behind the person's or the hidden name: "4711_prev.cpp", "text.html".
bool take_canvas_file(std::string_view rest, PlatformName& name) {
    if (rest == "text.html" || rest == "link.html") {
        name.file = rest;
        return true;
    }
    name.upload = take_while(rest, is_digit);
    if (name.upload.empty() || !take(rest, "_") || rest.empty()) return false;
    name.file = rest;
    return true;
}

/// Takes the mark from the end of a name.
bool take_late(std::string& person) {
    constexpr std::string_view mark = "_late";
    if (person.size() < mark.size()) return false;
    const std::size_t begin = person.size() - mark.size();
    if (!equal_in_small(std::string_view(person).substr(begin), mark))
        return false;
    person.resize(begin);
    return true;
}

std::optional<PlatformName> canvas_at(std::string_view entry,
                                      std::size_t underscore) {
    PlatformName name;
    std::string_view rest = entry.substr(underscore + 1);
    name.key = take_while(rest, is_digit);
    if (name.key.empty() || !take(rest, "_") || !take_canvas_file(rest, name))
        return std::nullopt;
    name.person = entry.substr(0, underscore);
    name.marked_late = take_late(name.person);
    return name;
}

std::optional<PlatformName> hidden_canvas(std::string_view entry) {
    PlatformName name;
    const bool is_late = equal_in_small(entry.substr(0, 5), "late_");
    std::string_view rest = entry.substr(is_late ? 5 : 0);
    if (!take(rest, "anon_")) return std::nullopt;
    if (equal_in_small(rest.substr(0, 5), "late_")) {
        name.marked_late = true;
        rest.remove_prefix(5);
    }
    name.marked_late = name.marked_late || is_late;
    name.key =
        take_while(rest, [](char c) { return is_digit(c) || is_letter(c); });
    if (name.key.empty() || !take(rest, "_") || !take_canvas_file(rest, name))
        return std::nullopt;
    name.person = "anon_" + name.key;
    return name;
}

/// The first underscore for which `parse` finds a name.
template <class Parse>
std::optional<PlatformName> first_that_fits(std::string_view entry,
                                            std::size_t from, Parse parse) {
    for (std::size_t at = entry.find('_', from); at != entry.npos;
         at = entry.find('_', at + 1))
        if (auto name = parse(entry, at)) return name;
    return std::nullopt;
}

}  // namespace

std::string_view words(Platform platform) {
    constexpr std::array<std::string_view, 5> all = {
        "plain folders", "Moodle", "Canvas", "Gradescope", "GitHub Classroom"};
    return all.at(static_cast<std::size_t>(platform));
}

std::optional<PlatformName> parse_moodle(std::string_view entry) {
    return first_that_fits(entry, 1, moodle_at);
}

std::optional<PlatformName> parse_canvas(std::string_view entry) {
    if (auto name = hidden_canvas(entry)) return name;
    return first_that_fits(entry, 0, canvas_at);
}

std::optional<PlatformName> parse_gradescope(std::string_view entry) {
    PlatformName name;
    if (!take(entry, "submission_")) return std::nullopt;
    name.key = take_while(entry, is_digit);
    if (name.key.empty() || !entry.empty()) return std::nullopt;
    return name;
}

}  // namespace grader
