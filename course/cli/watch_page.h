// What watch mode shows, without the terminal that shows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "course/cli/lists.h"
#include "course/cli/progress.h"
#include "course/cli/rechecker.h"
#include "course/cli/screen.h"
#include "course/runner/statement.h"

namespace course {

/// The exercise, as far as the student has come with it.
struct ExerciseView {
    Exercise exercise;
    Statement statement;
    std::string file;
    Progress progress;
    bool is_untouched = false;
    bool is_running = false, is_building = false;
    std::optional<CheckOutcome> outcome;
    std::size_t hints = 0;  ///< how many are shown
    std::string note;       ///< a line of lab's own; may be empty
};

/// Hints, result and statement; the statement before the result while the file
/// is untouched. On wide screens the statement stands on the right.
Page exercise_page(const ExerciseView& view, ScreenSize size);

/// The list to choose from: exercises that `filter` finds, the selected one
/// marked and in sight.
struct ListView {
    std::vector<Listed> found;
    Progress progress;
    std::string filter;
    std::size_t selected = 0;
};
Page list_page(const ListView& view, ScreenSize size);

/// Any other text, with a title.
Page text_page(const std::string& title, const std::string& text,
               const std::string& foot, ScreenSize size);

}  // namespace course
