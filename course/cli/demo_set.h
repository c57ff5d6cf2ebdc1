// The whole set of pages for the lecture.
#pragma once

#include <filesystem>

#include "course/cli/desk.h"

namespace course {

/// Writes into the folder: the pictures of the lecture notes; the walks of all
/// exercises that can be shown, of the references or, in a student's copy, of
/// the files that are begun; and index.html, which lists them by chapter. Says
/// on stderr how far it is, and which file does not compile; the others are
/// written all the same. About half a second for each exercise and core.
/// Returns the exit code. Throws SystemError and MeshFileError.
int demo_set(const Desk& desk, const std::filesystem::path& folder);

}  // namespace course
