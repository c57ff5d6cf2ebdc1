// The statement of an exercise, and its hints, in the student's language. Both
// languages stand in one file: English first, then what follows the line
// <!-- it --> in Italian.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/exercises.h"

namespace course {

enum class Language { english, italian };

/// The language of that name, "en" or "it"; also of a locale, "it_IT.UTF-8".
std::optional<Language> language_named(std::string_view name);

struct Statement {
    Language language = Language::english;  ///< that it is written in
    std::string title;                      ///< without the sign of a heading
    std::string text;                       ///< Markdown, without the hints
    std::vector<std::string> hints;         ///< in order
};

/// What a statement's file says in the wanted language, or in English where it
/// has no other.
Statement statement_in(std::string_view file, Language wanted);

/// The same of an exercise's file. Throws SystemError when it cannot be read.
Statement statement_of(const Exercise& exercise,
                       Language wanted = Language::english);

/// The part of a statement's file in that language, as it is written there;
/// empty when it has none.
std::string part_in(std::string_view file, Language language);

}  // namespace course
