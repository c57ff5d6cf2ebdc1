// The exercises of this tree. One exists because its files exist; there is no
// list of them anywhere.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/limits.h"

namespace course {

/// Where this tree and its build are.
std::filesystem::path source_root();
std::filesystem::path build_root();

struct Exercise {
    std::string topic;     ///< "01_traversal"
    std::string name;      ///< "face_sides", the name of its function and files
    bool is_data = false;  ///< the submission is a table and not a function
    Limits limits = {};    ///< of a submission, as long as nobody sets others

    /// "01_traversal/face_sides": the name in assignments and gradebooks.
    std::string full_name() const { return topic + "/" + name; }

    /// What a student hands in: "face_sides.cpp" or "complete_table.csv".
    std::string file_name() const;

    std::filesystem::path contract() const;
    std::filesystem::path skeleton() const;
    std::filesystem::path statement() const;

    /// The reference; a student's copy has none.
    std::filesystem::path solution() const;
};

/// All exercises in order of topic; within a topic in the order in which its
/// README names them, then by name.
std::vector<Exercise> all_exercises();

/// Thrown when there is no exercise of a name; names the nearest right one.
struct UnknownExercise : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The exercise of that name. Throws UnknownExercise.
Exercise exercise_named(const std::string& name);

/// Whether this tree has the reference solutions: a student's copy has none.
bool has_solutions();

/// The exercises that this one builds on: those whose contracts its contract
/// includes, and those that they build on. The exercise's submission may call
/// their functions: the references where the tree has solutions, else the
/// student's own.
std::vector<Exercise> exercises_before(const Exercise& exercise);

/// The <headers> that a text includes, by a look at its lines: one in a comment
/// counts too; and those that the project's headers bring which it includes.
/// Those are looked for below `include`.
std::set<std::string, std::less<>> standard_headers(
    std::string_view text, const std::filesystem::path& include);

/// A whole file. Throws SystemError that names it.
std::string read_file(const std::filesystem::path& file);

}  // namespace course
