// A class for the tests of ingest: a folder that is filled by hand.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "course/runner/temporary_folder.h"
#include "grader/pipeline/ingest.h"
#include "grader/tests/golden.h"

namespace grader::tests {

inline const std::vector<std::string> asked_for = {
    "boundary_walk.cpp", "complete_table.csv", "face_sides.cpp", "prev.cpp"};

inline std::string joined(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes) text += note + "\n";
    return text;
}

/// A submission as tests look at it: with the bytes of its files by name.
struct HandedIn {
    std::string student, id;
    std::map<std::string, std::string> files;
    std::vector<std::string> notes;
};

struct ClassHandedIn {
    std::vector<HandedIn> submissions;
    std::vector<std::string> notes;
};

inline ClassHandedIn with_bytes(const SubmittedClass& all,
                                const std::vector<std::string>& file_names) {
    ClassHandedIn read;
    read.notes = all.notes;
    for (const Submission& one : all.submissions) {
        HandedIn& to = read.submissions.emplace_back();
        to = {one.student, one.id, {}, one.notes};
        REQUIRE(one.files.size() == file_names.size());
        for (std::size_t k = 0; k < file_names.size(); ++k)
            if (one.files[k]) to.files[file_names[k]] = all.bytes(one, k);
    }
    return read;
}

class ClassOnDisk {
public:
    ClassOnDisk& file(const std::string& path,
                      const std::string& bytes = "int x;") {
        const auto full = folder_ / path;
        std::filesystem::create_directories(full.parent_path());
        std::ofstream(full, std::ios::binary) << bytes;
        return *this;
    }
    ClassOnDisk& link(const std::string& path,
                      const std::filesystem::path& to) {
        const auto full = folder_ / path;
        std::filesystem::create_directories(full.parent_path());
        std::filesystem::create_symlink(to, full);
        return *this;
    }
    ClassOnDisk& empty(const std::string& path) {
        std::filesystem::create_directories(folder_ / path);
        return *this;
    }
    std::filesystem::path at(const std::string& path) const {
        return folder_ / path;
    }
    /// Of the folder itself, or of the archive that lies in it.
    ClassHandedIn find(const std::string& path = ".",
                       const IngestLimits& limits = {}) const {
        return with_bytes(find_submissions(folder_ / path, asked_for, limits),
                          asked_for);
    }
    HandedIn only(const IngestLimits& limits = {}) const {
        const ClassHandedIn all = find(".", limits);
        REQUIRE(all.submissions.size() == 1);
        return all.submissions[0];
    }
    /// Everything that lies in the folder.
    std::set<std::string> contents() const {
        std::set<std::string> paths;
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(folder_.path()))
            paths.insert(entry.path().string());
        return paths;
    }

private:
    course::TemporaryFolder folder_;
};

}  // namespace grader::tests
