// Proves that a student's copy gives nothing away that is the instructor's.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// Something hidden that stands in a copy.
struct Leak {
    std::string file;  ///< relative to the copy
    int line = 0;      ///< from 1; 0: the file as a whole
    std::string what;

    friend bool operator==(const Leak&, const Leak&) = default;
};

/// "exercises/01_traversal/prev.cpp:12: a line of ...".
std::string text_of(const Leak& leak);

/// Lines of references that give something away: more than 40 characters, none
/// that contract or skeleton have too, none that anyone writes with such data.
std::set<std::string> secret_lines();

/// Names of the cases in the text of a suite, as Catch2 knows them.
std::vector<std::string> case_names(std::string_view suite);

/// Everything of these in the folder, by file and line: a file that lies in
/// solutions/ or grader/, or is equal to one there; a secret line; the name of
/// a hidden case. A name of 20 characters or more counts where it stands alone,
/// in quotes or between tags; in the midst of prose from 48 on, as short ones
/// are phrases of the contracts, too ("a few reads for each half-edge").
/// Reads every file of the folder and of this tree. Throws course::SystemError.
std::vector<Leak> leaks_in(const std::filesystem::path& copy);

}  // namespace grader
