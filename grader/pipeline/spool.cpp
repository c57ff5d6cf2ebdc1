#include "grader/pipeline/spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "course/runner/temporary_folder.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::Descriptor;

fs::path folder_for_temporary_files() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error)
        throw course::SystemError(
            "cannot use the folder for temporary files (TMPDIR, or /tmp): " +
            error.message());
    return folder;
}

Descriptor file_without_name() {
    const fs::path folder = folder_for_temporary_files();
    Descriptor file(
        ::open(folder.c_str(), O_TMPFILE | O_EXCL | O_RDWR | O_CLOEXEC, 0600));
    if (file) return file;
    // Some file systems only have files with names. This one goes at the end of
    // the block, and that of a grader killed here when the next one starts.
    const course::TemporaryFolder named;
    const fs::path path = named / "spool";
    file = Descriptor(
        ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600));
    if (!file) course::throw_errno("cannot make the file " + path.string());
    return file;
}

}  // namespace

Spool::Spool() : file_(file_without_name()) {}

Stored Spool::keep(std::string_view bytes) {
    const Stored stored{end_, bytes.size()};
    std::uint64_t at = end_;
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(file_.get(), bytes.data(), bytes.size(),
                                   static_cast<off_t>(at));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0)
            course::throw_errno(
                "cannot write submitted files to the folder for temporary "
                "files");
        bytes.remove_prefix(static_cast<std::size_t>(n));
        at += static_cast<std::uint64_t>(n);
    }
    end_ = at;
    return stored;
}

std::string Spool::read(const Stored& stored) const {
    std::string bytes(stored.size, '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n =
            ::pread(file_.get(), bytes.data() + done, bytes.size() - done,
                    static_cast<off_t>(stored.offset + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) course::throw_errno("cannot read submitted files again");
        if (n == 0)
            throw course::SystemError(
                "cannot read submitted files again: there are fewer bytes");
        done += static_cast<std::size_t>(n);
    }
    return bytes;
}

}  // namespace grader
