// Records walks: compiles a file in the traced build, lets the recorder call
// its function from every start, and reads what it wrote. The file runs in a
// process of its own, under the limits of lab.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/mesh/zoo.h"
#include "course/player/recording.h"
#include "course/runner/exercises.h"

namespace course {

struct RecordOptions {
    /// The student's file; empty: only the reference. Where there are no
    /// references, it must be given.
    std::filesystem::path file;
    /// Where to walk; none: the slide's mesh, or where a function can do
    /// nothing there, the first of the zoo on which it can.
    std::optional<Fixture> mesh;
    /// Where to start; none: from every half-edge (or vertex).
    std::vector<int> starts;
    /// Another compiler than that of this build.
    std::string compiler;
    /// Local variables, by gdb where it is present.
    bool locals = true;
};

/// Thrown when an exercise cannot be shown, or not so; says what can.
struct CannotShow : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Thrown when the file does not compile; what() is what the compiler said.
struct DoesNotCompile : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether the exercise's function takes or gives a half-edge table.
bool can_be_shown(const Exercise& exercise);

/// Throws CannotShow when it cannot; the message says what can.
void require_can_be_shown(const Exercise& exercise);

/// The names of those that can, a line for each chapter.
std::string what_can_be_shown();

/// Builds what recording their walks needs, if something is missing or old.
/// Precondition: they can be shown. Throws SystemError.
void make_ready_to_record(const std::vector<Exercise>& exercises);

/// Records the reference and the file; precondition: it was made ready. A walk
/// that ends in an error is no error: it is recorded up to there. Costs about a
/// second; with an endless loop that reads no table two more. Throws
/// CannotShow, DoesNotCompile, and SystemError when something of ours fails.
Recording record(const Exercise& exercise, const RecordOptions& options);

}  // namespace course
