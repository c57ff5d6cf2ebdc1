// The corpus of attacks: hostile submissions, each with what must become of it
// in its first line,
//   // <verdict>[ or <verdict>...] [<=]<points>|all: THREATS <items>, <what it
//   tries>
// and its place grader/tests/attacks/<exercise>/<item>_<what>.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/runner/results.h"

namespace grader {

struct Attack {
    std::filesystem::path file;
    std::string exercise;
    int item = 0;  ///< number in the list of threats, from the file's name
    std::vector<course::Verdict> verdicts;  ///< any of them is right
    std::optional<double> points;           ///< none: all that there are
    bool at_most = false;                   ///< fewer points are right, too
    std::string what;

    /// "face_sides/36_fork_bomb.cpp"
    std::string name() const;

    /// Whether the result is what the first line says.
    bool is_as_expected(const course::ExerciseResult& result) const;

    /// "run_time_error or wrong_answer, 0 points"
    std::string expectation() const;
};

/// Thrown when an attack says no expectation, or is not there.
struct BadAttack : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Writes the attack into the folder under the name that students hand in;
/// where it says @ROOT@, the root of this tree. Throws SystemError.
std::filesystem::path hand_in(const Attack& attack,
                              const std::filesystem::path& folder);

/// Throws BadAttack.
Attack read_attack(const std::filesystem::path& file);

/// The attack of that name, without ".cpp". Throws BadAttack and SystemError.
Attack attack_named(const std::string& exercise, const std::string& name);

/// All attacks, sorted by path. Throws BadAttack.
std::vector<Attack> attack_corpus();

}  // namespace grader
