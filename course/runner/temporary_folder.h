// A folder that is gone with its owner.
#pragma once

#include <filesystem>
#include <string>

#include "course/runner/descriptors.h"

namespace course {

/// While its owner lives, the folder is locked; of a process that was killed
/// it stays behind without a lock.
class TemporaryFolder {
public:
    /// Below the system's folder for such things, readable by its owner only.
    /// Throws SystemError.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

private:
    std::filesystem::path path_;
    Descriptor lock_;
};

/// Removes those that killed processes of this user left behind.
void remove_stale_temporary_folders();

}  // namespace course
