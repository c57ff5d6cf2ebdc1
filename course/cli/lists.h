// What the exercises, their chapters and their statements look like on a
// terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "course/cli/progress.h"
#include "course/runner/statement.h"

namespace course {

/// An exercise as lists show it.
struct Listed {
    Exercise exercise;
    std::string title;
};

/// All exercises in the order of the course. Reads the statement of each.
std::vector<Listed> all_listed(Language language);

/// Those that have the words in chapter, name or title, in any case of letters.
std::vector<Listed> found_by(std::string_view words,
                             const std::vector<Listed>& among);

/// A line for each exercise, below its chapter: name, state, title.
std::string list_of(const std::vector<Listed>& exercises,
                    const Progress& progress);

/// A line for each chapter, with a bar, and one for all.
std::string chapters_of(const Progress& progress);

/// "00:5/5 01:2/10 ...", solved ones of each chapter.
std::string short_chapters_of(const Progress& progress);

/// Markdown as it is read on a terminal: without the signs of headings, of
/// fences, of bold text and of links, a line for each paragraph.
std::string plain_markdown(std::string_view markdown);

}  // namespace course
