// The stored wrong submissions, grader/wrong/<topic>/<name>/<verdict>/*.cpp:
// what the suites must refuse, and what students' mistakes are recognised by.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/exercises.h"
#include "course/runner/verdict.h"

namespace grader {

struct WrongSubmission {
    std::filesystem::path file;
    course::Verdict verdict;  ///< that it must get: the name of its folder
};

struct WrongSubmissions {
    std::vector<WrongSubmission> all;           ///< ordered by file
    std::vector<std::filesystem::path> strays;  ///< of no verdict, or no source
};

/// Those of an exercise.
WrongSubmissions wrong_submissions(const course::Exercise& exercise);

/// What the comment at the top of one says.
struct MistakeText {
    std::string mistake;  ///< for instructors: "Stops one side too early."
    std::string hint;     ///< for students; empty where there is none
};

/// Of the lines that begin with // or #: those up to "Hint:", and those after.
MistakeText mistake_text(std::string_view source);

}  // namespace grader
