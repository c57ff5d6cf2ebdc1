// Finds what the students of a class handed in: a folder or an archive with a
// folder or an archive for each of them. Their names and files are data and may
// be hostile.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "grader/gradebook/member.h"
#include "grader/pipeline/file_time.h"
#include "grader/pipeline/lateness.h"
#include "grader/pipeline/platform_names.h"
#include "grader/pipeline/spool.h"

namespace grader {

/// The folder or archive of the class cannot be read, or not as a whole.
struct IngestError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What one submission may hold; more is refused, with a note.
struct IngestLimits {
    int folders = 3;     ///< depth below the student's own folder
    int entries = 2000;  ///< files and folders that are looked at
    std::size_t file_bytes = 4u << 20;
    std::size_t total_bytes = 16u << 20;
    /// The same, with files whose place another of their name took later. These
    /// stay on the disk until the end, and an archive can hold a name 20'000
    /// times; no honest student hands in as much.
    std::size_t written_bytes = 32u << 20;
    int archives = 10;  ///< that are opened
    /// Of an archive: its own size, and what is inflated of it, which in a tar
    /// includes the files that nobody asks for.
    std::size_t archive_bytes = 64u << 20;
    /// Of an archive, with those in folders that are not looked into.
    std::size_t archive_entries = 20'000;
    /// The same for the archive of a class: more is an IngestError.
    std::size_t class_bytes = std::size_t{2} << 30;
    std::size_t class_entries = 200'000;
};

/// What one student handed in.
struct Submission {
    /// Name of the folder or archive; of a platform's export the name and
    /// number ("Anna Rossi_1234"), the same in each of its layouts. Any bytes.
    std::string student;
    std::string id;  ///< safe in file names, unique in the class
    /// In the order of the names that were asked for; none: not handed in.
    std::vector<std::optional<Stored>> files;
    std::vector<std::string> notes;  ///< what was ignored or refused, and why
    std::string person, key;         ///< see PlatformName; empty: not known
    std::vector<Member> members;     ///< of a team, where the export says them
    bool marked_late = false;        ///< by the platform
    std::optional<Instant> submitted_at;  ///< where it is known
    std::vector<FileTime> modified;       ///< of the files, where that is known
};

/// Whether that is the submission's id, folder, person or number.
bool is_named(const Submission& submission, std::string_view name);

struct SubmittedClass {
    Platform platform = Platform::plain;
    std::vector<Submission> submissions;  ///< ordered by id
    std::vector<std::string> notes;       ///< about the folder of the class
    std::unique_ptr<const Spool> spool;   ///< has the bytes of all files

    /// The bytes of a submission's file, read from disk; for any number of
    /// threads at once. Precondition: it was handed in. Throws
    /// course::SystemError.
    std::string bytes(const Submission& submission, std::size_t file) const {
        return spool->read(*submission.files[file]);
    }
};

/// Reads the files of those names ("face_sides.cpp", "complete_table.csv")
/// from each folder in `dir`. Only regular files count, and links are never
/// followed. Of several files of one name the least deep is taken, then the
/// first by its path; a note names the others. A folder without any is still
/// a submission. The same folder gives the same result on every machine.
///
/// An archive (archive_format in archive.h) counts as a folder of its name;
/// one inside another is not opened. One that cannot be read as a whole gives
/// nothing but a note. Beside the students' folders "anna.zip" is the
/// submission of anna, unless she has a folder as well. `dir` may itself be an
/// archive, which is read as if it were unpacked; where it is broken, nobody is
/// graded by half: an IngestError.
///
/// Notes hold the students' own file names: escape them before showing.
/// Memory is taken for names and notes, and for the files of one archive at a
/// time. Preconditions: no other thread runs, and the names differ. Throws
/// IngestError, and course::SystemError when an archive's process cannot be
/// started or the files do not fit on the disk.
///
/// The export of a platform (see export_layout.h) is recognised by its names,
/// also where all of it lies in one folder; a note says which. `platform` takes
/// the export for one of that.
SubmittedClass find_submissions(const std::filesystem::path& dir,
                                const std::vector<std::string>& file_names,
                                const IngestLimits& limits = {},
                                std::optional<Platform> platform = {});

}  // namespace grader
