// Where a student's own files are, and what becomes of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "course/runner/exercises.h"

namespace course {

/// A folder with exercises/, where the student writes, and .lab/, where lab
/// keeps what it has to remember. Usually the tree that lab was built in.
struct Desk {
    std::filesystem::path root = source_root();

    /// The student's file for an exercise, as seen from the working folder.
    std::filesystem::path file(const Exercise& exercise) const;

    std::filesystem::path memory() const { return root / ".lab"; }

    /// The file as it was handed out; nothing where no copy of it was kept, as
    /// in a tree that is not a student's.
    std::optional<std::string> original(const Exercise& exercise) const;

    /// Whether the file is as it was handed out.
    bool is_untouched(const Exercise& exercise) const;

    /// Puts the original back, and the student's file below .lab/backup: where
    /// it went, nothing if there was none. Throws CannotBegin without an
    /// original, MeshFileError when a file cannot be written.
    std::optional<std::filesystem::path> reset(const Exercise& exercise) const;
};

}  // namespace course
