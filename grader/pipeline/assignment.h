// What a class is graded on: the exercises, their weights, when they are due,
// and how much of the hidden cases students may see.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/exercises.h"
#include "grader/pipeline/lateness.h"

namespace grader {

/// What a student is told about a hidden case that failed.
enum class FeedbackLevel {
    names,            ///< its name and points
    names_and_hints,  ///< and the hint of its author
    full,             ///< everything, as for a public case
};

/// The same before and after the due date, unless the file says otherwise.
struct HiddenFeedback {
    FeedbackLevel before_due = FeedbackLevel::names_and_hints;
    FeedbackLevel after_due = FeedbackLevel::names_and_hints;

    friend bool operator==(const HiddenFeedback&,
                           const HiddenFeedback&) = default;
};

struct Assignment {
    struct Item {
        std::string exercise;   ///< as in the list of known names
        double weight = 1;      ///< multiplies the exercise's points
        bool is_bonus = false;  ///< adds to what is reached, not to the maximum
        course::Limits limits = {};  ///< of a submission of it

        friend bool operator==(const Item&, const Item&) = default;
    };

    std::string name;
    std::vector<Item> exercises;  ///< in the order of the reports
    HiddenFeedback hidden_feedback = {};
    std::optional<DueDate> due = {};
    double rounding = 0;  ///< totals are multiples of it; 0: not rounded
    LatePolicy late = {};
    bool in_teams = false;  ///< a submission is that of several students

    friend bool operator==(const Assignment&, const Assignment&) = default;
};

/// One mistake in an assignment file.
struct AssignmentMistake {
    int line = 0;  ///< 1 is the first; 0 when it is about the file as a whole
    int column = 0;
    std::string what;  ///< what was found and what was expected

    friend bool operator==(const AssignmentMistake&,
                           const AssignmentMistake&) = default;
};

/// Thrown with every mistake of a file, in the order of the file. what() has a
/// line for each: "first_light.toml:7:1: ...".
struct AssignmentError : std::runtime_error {
    AssignmentError(const std::filesystem::path& file,
                    std::vector<AssignmentMistake> all);
    std::vector<AssignmentMistake> mistakes;
};

/// Reads an assignment file (see grader/assignments/first_light.toml).
/// `known` are the exercises there are, as "01_traversal/face_sides" or
/// "face_sides"; the file may leave out the chapter.
/// Throws AssignmentError, also for a file of more than 16 KiB.
Assignment read_assignment(const std::filesystem::path& file,
                           const std::vector<std::string>& known);

/// What is graded without a file: every exercise in `known`, with weight 1.
Assignment default_assignment(const std::vector<std::string>& known);

/// The exercises of an assignment, with their limits there; all of this tree
/// without one. Throws course::UnknownExercise.
std::vector<course::Exercise> exercises_of(
    const std::optional<Assignment>& assignment);

/// What students may be told of hidden cases at that moment.
FeedbackLevel hidden_feedback_at(const Assignment& assignment, Instant now);

/// The limits of some exercises of an assignment.
struct SharedLimits {
    course::Limits limits;
    std::vector<std::string> exercises;  ///< their short names
    std::string title;                   ///< "limits", "limits of tip, prev"
};

/// Those that most exercises have come first and are told without names.
std::vector<SharedLimits> limits_of(const Assignment& assignment);

/// "2 s for a call, 5 s for a case, 20 s for all; 0.25 s of CPU in which a case
/// ends or takes more memory; 512 MiB".
std::string text_of(const course::Limits& limits);

/// "face_sides" of "01_traversal/face_sides".
std::string_view short_name(std::string_view exercise);

/// "01_traversal" of "01_traversal/face_sides"; empty when there is none.
std::string_view chapter(std::string_view exercise);

}  // namespace grader
