// What the exercises, their chapters and their statements look like on a
// terminal.
#pragma once

#include <string>
#include <string_view>

#include "course/cli/progress.h"
#include "course/runner/statement.h"

namespace course {

/// Whether chapter, name or title has the words in it, in any case of letters.
bool is_found_by(const Exercise& exercise, const std::string& title,
                 std::string_view words);

/// A line for each exercise, below its chapter: name, state, title.
std::string list_of(const Progress& progress, Language language,
                    std::string_view filter);

/// A line for each chapter, with a bar, and one for all.
std::string chapters_of(const Progress& progress);

/// "00:5/5 01:2/10 ...", solved ones of each chapter.
std::string short_chapters_of(const Progress& progress);

/// Markdown as it is read on a terminal: without the signs of headings, of
/// fences, of bold text and of links, a line for each paragraph.
std::string plain_markdown(std::string_view markdown);

}  // namespace course
