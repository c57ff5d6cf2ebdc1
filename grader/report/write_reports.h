// All files that a run leaves for people and for other programs.
#pragma once

#include <filesystem>

#include "grader/report/class_summary.h"

namespace grader {

/// Writes grades.csv, report.html and, for each student of the newest run,
/// feedback.html, results.json and junit.xml in students/<id>; makes the
/// folders. Each file is replaced as a whole, and equal results give equal
/// bytes, but for the time in the pages' <time> element. A student's file that
/// has these bytes already is left alone.
/// Returns what the files of the class were made from. Has the results of one
/// student in memory at a time.
/// Throws GradebookError; course::MeshFileError or
/// std::filesystem::filesystem_error when a file or folder cannot be written.
ClassSummary write_reports(const Gradebook& gradebook,
                           const Assignment& assignment,
                           const std::filesystem::path& out);

}  // namespace grader
