// What lab remembers of a student's work, in .lab/progress: a line for each
// exercise that was ever checked, to be read by people as well.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "course/cli/desk.h"

namespace course {

enum class State {
    untouched,
    tried,   ///< checked, and never accepted
    solved,  ///< accepted, the last time that it was checked
    broken,  ///< accepted once, and not the last time
};

/// "", "tried", "solved", "BROKEN": as lists show it.
std::string_view words(State state);

struct Progress {
    struct Entry {
        State state = State::untouched;
        std::string mark;  ///< of the text that was checked; see mark_of
    };

    std::string current;  ///< the exercise that is worked on; may be empty
    std::map<std::string, Entry> entries;

    State state(const Exercise& exercise) const;

    /// A check has ended: what was checked, and whether it was accepted.
    void note(const Exercise& exercise, std::string_view text, bool accepted);

    /// The one to work on: `current` if there is one of that name, else the
    /// first that is not solved, else the first.
    Exercise current_exercise() const;

    /// The first after it in the order of the course, from the last on to the
    /// first, that is not solved; itself when all others are.
    Exercise next_after(const Exercise& exercise) const;
};

/// 16 hexadecimal digits that another text does not have by accident.
std::string mark_of(std::string_view text);

/// Empty when there is no file yet. Throws CannotBegin with file and line where
/// a line is none of ours.
Progress read_progress(const Desk& desk);

/// Reads, changes and writes it, while no other lab does. Throws CannotBegin,
/// MeshFileError when it cannot be written.
void change_progress(const Desk& desk,
                     const std::function<void(Progress&)>& change);

/// Desk::reset, and forgets what was known of the exercise.
std::optional<std::filesystem::path> reset_exercise(const Desk& desk,
                                                    const Exercise& exercise);

/// The exercise of that name; the current one where it is empty. Throws
/// UnknownExercise.
Exercise exercise_or_current(const Desk& desk, const std::string& name);

}  // namespace course
