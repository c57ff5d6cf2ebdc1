// Finds what the students of a class handed in: a folder with a folder for
// each of them. Their names and files are data and may be hostile.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace grader {

/// The folder of the class cannot be read.
struct IngestError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What one submission may hold; more is refused, with a note.
struct IngestLimits {
    int folders = 3;     ///< depth below the student's own folder
    int entries = 2000;  ///< files and folders that are looked at
    std::size_t file_bytes = 4u << 20;
    std::size_t total_bytes = 16u << 20;
};

struct SubmittedFile {
    std::string bytes;
    std::string path;  ///< below the student's folder: "week1/face_sides.cpp"
};

/// What one student handed in.
struct Submission {
    std::string student;  ///< the folder's name: any bytes
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
/// Notes hold the students' own file names: escape them before showing.
/// Throws IngestError.
SubmittedClass find_submissions(const std::filesystem::path& dir,
                                const std::vector<std::string>& file_names,
                                const IngestLimits& limits = {});

}  // namespace grader
