// What may be wrong with a mesh file, and the work on its text that the OBJ and
// OFF code have in common.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// One thing wrong with a mesh file.
struct FileDefect {
    int line;  ///< from 1; 0: the file as a whole
    std::string what;

    friend bool operator==(const FileDefect&, const FileDefect&) = default;
};

/// Thrown for a mesh file that cannot be read or written. what() has a line
/// for each defect: `cube.obj:9: f has 2 corners, expected at least 3`.
class MeshFileError : public std::runtime_error {
public:
    MeshFileError(const std::filesystem::path& file,
                  std::vector<FileDefect> defects);
    /// By line; after a thousand the last one only counts the others.
    const std::vector<FileDefect>& defects() const { return defects_; }

private:
    std::vector<FileDefect> defects_;
};

/// Collects defects while a file is read: the first thousand, and how many
/// more there are.
class FileDefects {
public:
    void add(int line, std::string what);
    /// Throws MeshFileError with what was added, by line; else does nothing.
    void throw_if_any(const std::filesystem::path& file);

private:
    std::vector<FileDefect> defects_;
    std::size_t left_out_ = 0;
};

/// Writes the whole file under another name beside it and renames that: the
/// file is the old or the new one at any time. Throws MeshFileError.
void replace_text(const std::filesystem::path& file, std::string_view text);

/// Throws std::invalid_argument when the mesh cannot go into a file and come
/// back: a coordinate that is not finite, a face with fewer than three corners,
/// an index that is no vertex.
void require_writable(const IndexedMesh& mesh);

/// The lines of a text or a file, without comments (`#` to the end) and the
/// blanks around. They end in LF, CRLF or CR, the last one perhaps in nothing;
/// a byte order mark is passed over.
class Lines {
public:
    /// Precondition: the text outlives it.
    explicit Lines(std::string_view text);
    /// Reads the file as it goes: memory for its longest line, and a little.
    /// Throws MeshFileError when it cannot be read, as `next` does.
    explicit Lines(const std::filesystem::path& file);
    /// Goes to the next line, at first to the first; false after the last.
    bool next();
    /// Until the next call of `next`.
    std::string_view line() const { return line_; }
    int number() const { return number_; }

private:
    std::size_t end_of_line();
    bool read_on();

    std::filesystem::path file_;
    std::ifstream in_;
    bool is_all_ = true;       ///< nothing more is to be read
    std::string block_;        ///< of the file, from somewhere on
    std::string_view rest_;    ///< what comes after the line
    std::size_t newline_ = 0;  ///< no LF in rest_ comes before it
    std::string_view line_;
    int number_ = 0;
};

/// Puts the words between blanks and tabs into a list, whose memory is used
/// again.
void split(std::string_view line, std::vector<std::string_view>& words);

/// The word as messages show it: in quotes, short, and printable.
std::string quoted(std::string_view word);

/// `1 corner`, `2 corners`.
std::string counted(std::size_t n, const char* noun);

/// Reads a finite number, in any locale; returns what is wrong with the word,
/// or "". `1`, `+.5`, `-2e3` are numbers; `nan`, `1e999`, `1x` are not.
std::string read_number(std::string_view word, double& value);

/// Reads a whole number; returns what is wrong with the word, or "".
std::string read_integer(std::string_view word, int& value);

}  // namespace course
