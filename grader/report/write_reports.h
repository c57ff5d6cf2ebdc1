// All files that a run leaves for people and for other programs.
#pragma once

#include <filesystem>

#include "grader/report/class_results.h"

namespace grader {

/// Writes grades.csv, report.html and, for each student, feedback.html,
/// results.json and junit.xml in students/<id>; makes the folders. Each file is
/// replaced as a whole, and equal results give equal bytes, but for the time
/// in the pages' <time> element.
/// Throws course::MeshFileError or std::filesystem::filesystem_error when a
/// file or folder cannot be written.
void write_reports(const ClassResults& results,
                   const std::filesystem::path& out);

}  // namespace grader
