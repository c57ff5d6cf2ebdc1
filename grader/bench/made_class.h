// Classes that nobody teaches: as many students as asked for, with files that
// are all different, the same ones for the same seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "course/runner/exercises.h"

namespace grader::bench {

/// What the students hand in.
enum class Content {
    references,  ///< the solutions
    mixed,       ///< half solutions, the rest skeletons and stored wrong
                 ///< submissions; one in twenty loops for ever
};

struct ClassShape {
    int students = 1;
    std::vector<course::Exercise> exercises;
    Content content = Content::references;
    std::uint32_t seed = 1;
};

/// One file that one student hands in.
struct HandedIn {
    course::Exercise exercise;
    std::filesystem::path file;
};

struct MadeClass {
    std::filesystem::path folder;      ///< a folder for each student
    std::filesystem::path assignment;  ///< names the exercises
    std::vector<HandedIn> files;       ///< student by student
};

/// At most so many exercises in C++, from all chapters alike.
std::vector<course::Exercise> chosen_exercises(int most);

/// Writes a class into the new folder `at`. Every file is different by a line
/// of comment. Throws SystemError and std::filesystem::filesystem_error.
MadeClass make_class(const std::filesystem::path& at, const ClassShape& shape);

}  // namespace grader::bench
