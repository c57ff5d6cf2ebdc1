// Files for the tests of the mesh readers and writers.
#pragma once

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "course/mesh/file_defects.h"
#include "course/runner/temporary_folder.h"

namespace course {

/// A file of that text in the folder.
inline std::filesystem::path file_of(const TemporaryFolder& folder,
                                     std::string_view text) {
    const std::filesystem::path file = folder / "mesh.txt";
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

inline std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The defects that `read` reports of a file of that text.
template <class Read>
std::vector<FileDefect> defects_of(Read read, std::string_view text) {
    const TemporaryFolder folder;
    try {
        read(file_of(folder, text));
    } catch (const MeshFileError& error) {
        return error.defects();
    }
    return {};
}

/// What the exception says that `act` throws; empty when it throws none.
template <class Act>
std::string message_of(Act act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

}  // namespace course
