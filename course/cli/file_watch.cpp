#include "course/cli/file_watch.h"

#include <sys/stat.h>
#include <unistd.h>

#include "course/runner/platform.h"

#if COURSE_LINUX
#include <sys/inotify.h>
#endif

#include <utility>

namespace course {

namespace {

namespace fs = std::filesystem;

/// Notices of what is written in, or moved into, a folder; none where the
/// system has no such thing.
Descriptor notices_of([[maybe_unused]] const fs::path& folder) {
#if COURSE_LINUX
    Descriptor notices(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    if (notices && ::inotify_add_watch(notices.get(), folder.c_str(),
                                       IN_CLOSE_WRITE | IN_MOVED_TO) >= 0)
        return notices;
#endif
    return {};
}

}  // namespace

FileWatch::FileWatch(fs::path file)
    : file_(std::move(file)),
      notices_(notices_of(fs::absolute(file_).parent_path())),
      last_(stamp()) {}

std::chrono::milliseconds FileWatch::patience() const {
    return std::chrono::milliseconds(notices_ ? 1000 : 150);
}

bool FileWatch::has_changed() {
    char dropped[4096];
    while (notices_ && ::read(notices_.get(), dropped, sizeof dropped) > 0) {
    }
    const Stamp now = stamp();
    return now != Stamp{} && now != std::exchange(last_, now);
}

FileWatch::Stamp FileWatch::stamp() const {
    struct stat status {};
    if (::stat(file_.c_str(), &status) != 0) return {};
#ifdef __APPLE__
    const timespec time = status.st_mtimespec;
#else
    const timespec time = status.st_mtim;
#endif
    return {std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec,
            static_cast<std::uint64_t>(status.st_size),
            static_cast<std::uint64_t>(status.st_ino)};
}

}  // namespace course
