// What a result depends on, as a hash: the same key means the same result, and
// nothing is judged twice.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/exercises.h"

namespace grader {

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view bytes);

/// The seeds that a submission is judged with, one for each repetition: other
/// ones for each source, so that no answer can be prepared for them, and always
/// the same ones for the same source and seed of the run.
std::vector<std::uint64_t> judging_seeds(std::uint64_t seed, int repeats,
                                         std::string_view source);

/// Keys of submissions under this build: source, suite, headers, flags,
/// compiler, worker, limits of the exercise, seed and isolation all go in.
class Keys {
public:
    /// Reads what does not depend on the submission. Throws SystemError when
    /// the build is not complete.
    Keys(const std::vector<course::Exercise>& exercises,
         const std::string& surroundings);

    /// Changes when the suite of the exercise changes.
    std::string suite_version(const course::Exercise& exercise) const;

    std::string of(const course::Exercise& exercise,
                   std::string_view source) const;

private:
    std::map<std::string, std::string> suites_;  ///< by name of the exercise
    std::string common_;
};

}  // namespace grader
