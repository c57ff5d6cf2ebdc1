#include "grader/pipeline/folders.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

namespace grader {

using course::Descriptor;

namespace {

std::string refused_by_system() {
    return fmt::format("cannot be read ({}): refused", std::strerror(errno));
}

ReadFile read_bytes(int fd, std::size_t size) {
    std::string bytes(size + 1, '\0');  // one more, to see whether it grows
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = read(fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {{}, refused_by_system()};
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    if (done > size) return {{}, "grew while it was read: refused"};
    bytes.resize(done);
    return {std::move(bytes), {}};
}

}  // namespace

Descriptor open_folder(int parent, const std::string& name) {
    return Descriptor(openat(parent, name.c_str(),
                             O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

Descriptor open_below(int root, std::string_view path) {
    Descriptor folder = open_folder(root, ".");
    while (folder && !path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        folder = open_folder(folder.get(), std::string(path.substr(0, slash)));
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return folder;
}

Listing names_in(int folder, std::size_t most) {
    Listing listing;
    const int copy = fcntl(folder, F_DUPFD_CLOEXEC, 0);
    const std::unique_ptr<DIR, int (*)(DIR*)> stream(fdopendir(copy), closedir);
    if (!stream) {
        close(copy);
        return listing;
    }
    rewinddir(stream.get());  // the copy shares the place in the folder
    while (const dirent* entry = readdir(stream.get())) {
        const std::string name = entry->d_name;
        if (name == "." || name == "..") continue;
        listing.whole = listing.names.size() < most;
        if (!listing.whole) break;
        listing.names.push_back(name);
    }
    std::sort(listing.names.begin(), listing.names.end());
    return listing;
}

FileKind kind_of(int folder, const std::string& name) {
    struct stat status {};
    if (fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return FileKind::gone;
    if (S_ISREG(status.st_mode)) return FileKind::file;
    if (S_ISDIR(status.st_mode)) return FileKind::folder;
    return S_ISLNK(status.st_mode) ? FileKind::link : FileKind::other;
}

/// Opens without following a link and without waiting for a FIFO's writer, and
/// looks at what was opened, not at what stood there before.
OpenedFile open_file(int folder, const std::string& name, std::size_t most) {
    OpenedFile opened;
    opened.file = Descriptor(
        openat(folder, name.c_str(),
               O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat status {};
    if (!opened.file || fstat(opened.file.get(), &status) != 0) {
        opened.why_not = refused_by_system();
        return opened;
    }
    opened.size = static_cast<std::size_t>(status.st_size);
    opened.modified = FileTime{status.st_mtim.tv_sec, false};
    if (!S_ISREG(status.st_mode))
        opened.why_not = "is not a regular file: refused";
    else if (opened.size > most)
        opened.why_not = fmt::format(
            "has {} bytes; at most {} are taken: refused", opened.size, most);
    return opened;
}

ReadFile read_file(int folder, const std::string& name, std::size_t most) {
    const OpenedFile opened = open_file(folder, name, most);
    if (!opened.why_not.empty()) return {{}, opened.why_not};
    ReadFile file = read_bytes(opened.file.get(), opened.size);
    file.modified = opened.modified;
    return file;
}

}  // namespace grader
