#include "course/runner/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>

namespace course {

namespace {

namespace fs = std::filesystem;

const std::string prefix = "course-";

Descriptor open_folder(const fs::path& folder) {
    return Descriptor(::open(folder.c_str(),
                             O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

/// A folder that is not locked may be one that is just being made.
bool is_old(const struct stat& status) {
    constexpr std::time_t a_minute = 60;
    return std::time(nullptr) - status.st_mtime > a_minute;
}

bool is_stale(const fs::path& folder) {
    struct stat status {};
    const Descriptor fd = open_folder(folder);
    return fd && ::fstat(fd.get(), &status) == 0 &&
           status.st_uid == ::geteuid() && is_old(status) &&
           ::flock(fd.get(), LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = fs::temp_directory_path() / (prefix + "XXXXXX");
    if (::mkdtemp(name.data()) == nullptr)
        throw_errno("cannot make a folder " + name);
    path_ = name;
    lock_ = open_folder(path_);
    // Where locks are not to be had, nothing of a killed process is removed.
    if (lock_) ::flock(lock_.get(), LOCK_EX | LOCK_NB);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void remove_stale_temporary_folders() {
    std::error_code ignored;
    for (const auto& entry :
         fs::directory_iterator(fs::temp_directory_path(), ignored)) {
        const std::string name = entry.path().filename();
        if (name.size() == prefix.size() + 6 && name.rfind(prefix, 0) == 0 &&
            is_stale(entry.path()))
            fs::remove_all(entry.path(), ignored);
    }
}

}  // namespace course
