// Finds what the students of a class handed in: a folder or an archive with a
// folder or an archive for each of them. Their names and files are data and may
// be hostile.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

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

struct SubmittedFile {
    std::string bytes;
    /// Below the student's folder: "week1/face_sides.cpp", and of a file in
    /// an archive "homework.zip/week1/face_sides.cpp".
    std::string path;
};

/// What one student handed in.
struct Submission {
    std::string student;  ///< name of the folder or archive: any bytes
    std::string id;       ///< safe in file names, unique in the class
    std::map<std::string, SubmittedFile> files;  ///< by name of the exercise's
    std::vector<std::string> notes;  ///< what was ignored or refused, and why
};

struct SubmittedClass {
    std::vector<Submission> submissions;  ///< ordered by id
    std::vector<std::string> notes;       ///< about the folder of the class
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
/// Precondition: no other thread runs. Throws IngestError, and
/// course::SystemError when an archive's process cannot be started.
SubmittedClass find_submissions(const std::filesystem::path& dir,
                                const std::vector<std::string>& file_names,
                                const IngestLimits& limits = {});

}  // namespace grader
