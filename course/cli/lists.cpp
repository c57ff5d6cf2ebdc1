#include "course/cli/lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "course/mesh/ascii.h"

namespace course {

namespace {

struct Count {
    int solved = 0, all = 0;
};

std::map<std::string, Count> counts_of(const Progress& progress) {
    std::map<std::string, Count> counts;
    for (const Exercise& exercise : all_exercises()) {
        Count& count = counts[exercise.topic];
        ++count.all;
        if (progress.state(exercise) == State::solved) ++count.solved;
    }
    return counts;
}

std::string bar(Count count) {
    constexpr int columns = 20;
    const int full = count.all == 0 ? 0 : columns * count.solved / count.all;
    std::string text;
    for (int k = 0; k < columns; ++k) text += k < full ? "█" : "·";
    return text;
}

std::string plain_line(const std::string& line) {
    static const std::regex heading("^#+ "), bold("\\*\\*"),
        link("\\[([^\\]]*)\\]\\([^)]*\\)");
    std::string plain = std::regex_replace(line, heading, "");
    plain = std::regex_replace(plain, bold, "");
    return std::regex_replace(plain, link, "$1");
}

/// Prose, whose lines end where they did by accident.
bool can_be_joined(const std::string& line) {
    return !line.empty() && line[0] != '|' && line[0] != '#';
}

/// Items of a list, and what is set off by bold text.
bool begins_anew(const std::string& line) {
    static const std::regex start("^ *([-*] |[0-9]+[.] |[*][*]).*");
    return std::regex_match(line, start);
}

}  // namespace

std::vector<Listed> all_listed(Language language) {
    std::vector<Listed> all;
    for (const Exercise& exercise : all_exercises())
        all.push_back({exercise, statement_of(exercise, language).title});
    return all;
}

std::vector<Listed> found_by(std::string_view words,
                             const std::vector<Listed>& among) {
    const std::string wanted = ascii_lower(words);
    std::vector<Listed> found;
    for (const Listed& one : among)
        if (ascii_lower(one.exercise.topic + " " + one.exercise.name + " " +
                        one.title)
                .find(wanted) != std::string::npos)
            found.push_back(one);
    return found;
}

std::string list_of(const std::vector<Listed>& exercises,
                    const Progress& progress) {
    std::string text, topic;
    for (const auto& [exercise, title] : exercises) {
        if (exercise.topic != topic)
            text += fmt::format("{}{}\n", topic.empty() ? "" : "\n",
                                exercise.topic);
        topic = exercise.topic;
        text += fmt::format("  {:<22} {:<7} {}\n", exercise.name,
                            words(progress.state(exercise)), title);
    }
    return text;
}

std::string chapters_of(const Progress& progress) {
    std::string text;
    Count sum;
    for (const auto& [topic, count] : counts_of(progress)) {
        text += fmt::format("{:<16} {} {:>3} of {:<3}\n", topic, bar(count),
                            count.solved, count.all);
        sum = {sum.solved + count.solved, sum.all + count.all};
    }
    return text + fmt::format("{:<16} {} {:>3} of {:<3}\n", "all", bar(sum),
                              sum.solved, sum.all);
}

std::string short_chapters_of(const Progress& progress) {
    std::string text;
    for (const auto& [topic, count] : counts_of(progress))
        text += fmt::format("{}{}:{}/{}", text.empty() ? "" : " ",
                            topic.substr(0, topic.find('_')), count.solved,
                            count.all);
    return text;
}

std::string plain_markdown(std::string_view markdown) {
    std::istringstream lines{std::string(markdown)};
    std::string text;
    bool is_code = false, was_prose = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("```", 0) == 0) {
            is_code = !is_code;
            was_prose = false;
            continue;
        }
        const bool is_prose = !is_code && can_be_joined(line);
        if (was_prose && is_prose && !begins_anew(line)) text.back() = ' ';
        text += (is_code ? line : plain_line(line)) + "\n";
        was_prose = is_prose;
    }
    return text;
}

}  // namespace course
