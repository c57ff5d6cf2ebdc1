// A class as programs want it that look for copied code: JPlag reads a folder
// of submissions and a base code, Dolos a CSV of the files of one exercise.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/runner/exercises.h"
#include "grader/pipeline/ingest.h"

namespace grader {

enum class Naming {
    ids,        ///< Submission::id
    anonymous,  ///< student_001 ..., in no order that tells anything
};

/// Writes into `folder`, which is empty:
///   submissions/<name>/<file>  of each student who handed in something
///   base/<file>                the skeletons, which everybody was given
///   info_<exercise>.csv        `filename,full_name` of each that is a program
/// Dolos's library 3.5.1 reads it so, and finds nothing alike in two skeletons.
/// Names in info_*.csv are data: escaped for spreadsheets. What is in the files
/// themselves, as a name in a comment, stays.
/// Returns the name that each submission has there, in their order.
std::vector<std::string> export_for_similarity(
    const SubmittedClass& submitted,
    const std::vector<course::Exercise>& exercises, Naming naming,
    const std::filesystem::path& folder);

/// `name,student` and a line for each: what anonymous names stand for.
std::string names_csv(const SubmittedClass& submitted,
                      const std::vector<std::string>& names);

}  // namespace grader
