// Files for the tests of the readers and writers, in a folder that goes away.
#pragma once

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "course/mesh/file_defects.h"

namespace course {

class TemporaryFolder {
public:
    TemporaryFolder()
        : path_(std::filesystem::temp_directory_path() /
                ("course-test-" + std::to_string(std::random_device()()))) {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// A file of that text in the folder.
    std::filesystem::path file(std::string_view text) const {
        const std::filesystem::path file = path_ / "mesh.txt";
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

private:
    std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The defects that `read` reports of a file of that text.
template <class Read>
std::vector<FileDefect> defects_of(Read read, std::string_view text) {
    const TemporaryFolder folder;
    try {
        read(folder.file(text));
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
