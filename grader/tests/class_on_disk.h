// A class for the tests of ingest: a folder that is filled by hand.
#pragma once

#include <filesystem>
#include <fstream>
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

class ClassOnDisk {
public:
    ClassOnDisk& file(const std::string& path,
                      const std::string& bytes = "int x;") {
        const auto full = folder_ / path;
        std::filesystem::create_directories(full.parent_path());
        std::ofstream(full, std::ios::binary) << bytes;
        return *this;
    }
    std::filesystem::path at(const std::string& path) const {
        return folder_ / path;
    }
    /// Of the folder itself, or of the archive that lies in it.
    SubmittedClass find(const std::string& path = ".",
                        const IngestLimits& limits = {}) const {
        return find_submissions(folder_ / path, asked_for, limits);
    }
    Submission only(const IngestLimits& limits = {}) const {
        SubmittedClass all = find(".", limits);
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
