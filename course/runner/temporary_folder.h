// A folder that is gone with its owner.
#pragma once

#include <filesystem>
#include <string>

namespace course {

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
};

}  // namespace course
