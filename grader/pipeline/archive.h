// Reads the files of an archive whose every byte may be hostile. Nothing is
// unpacked: names and bytes are handed over, and links, devices and names that
// lead elsewhere are refused.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "grader/pipeline/file_time.h"

namespace grader {

/// The archive is broken, is none, or holds more than the limits allow.
struct ArchiveError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A tar may be compressed by gzip, bzip2, xz or zstd, which its bytes tell.
enum class ArchiveFormat { zip, tar };

/// What a file's name promises: .zip .tar .tgz .tar.gz .tar.bz2 .tar.xz
/// .tar.zst, in capitals or small letters.
std::optional<ArchiveFormat> archive_format(std::string_view file_name);

/// "homework" of "homework.tar.gz"; any other name as it is.
std::string_view archive_stem(std::string_view file_name);

/// Beyond these the whole archive is an ArchiveError.
struct ArchiveLimits {
    std::uint64_t entries = 20'000;
    /// What is inflated. In a tar, files that nobody wants are inflated as
    /// well, and count.
    std::uint64_t bytes = std::uint64_t{64} << 20;
    /// No more are ever asked for of one file.
    std::uint64_t file_bytes = std::uint64_t{64} << 20;
};

/// One entry, in the order of the archive.
struct ArchiveEntry {
    enum class Kind : std::uint8_t { file, folder, refused };

    std::uint64_t index = 0;  ///< from 1
    Kind kind = Kind::refused;
    /// "a/b.cpp", of a folder "a/b": any bytes but NUL and backslash, and no
    /// component is empty, "." or "..". Of a refused entry what the archive
    /// says, shortened; empty when its name cannot be told.
    std::string path;
    std::string refusal;               ///< why, of a refused entry
    std::optional<std::string> bytes;  ///< of a file that is wanted
    std::optional<FileTime> modified = {};
};

/// How many bytes a file of that path may have; nothing: it is not wanted, and
/// comes without its bytes. A file with more becomes a refused entry.
using MostBytes = std::function<std::optional<std::size_t>(std::string_view)>;

using TakeEntry = std::function<void(ArchiveEntry)>;

/// Hands the entries to `take`, in this process. `fd` is a file or a memfd, at
/// any position. Of two entries of one path both are handed over. A zip whose
/// directory and local headers disagree is broken, and so is one with overlaps
/// or with anything after its directory. Throws ArchiveError, after some
/// entries perhaps; what `take` throws passes through.
void read_archive(int fd, ArchiveFormat format, const ArchiveLimits& limits,
                  const MostBytes& most_bytes, const TakeEntry& take);

/// The same, with the reading done in a child process without rights that may
/// use so many seconds of CPU. `most_bytes` is called there and here, `take`
/// here. Precondition: no other thread runs.
void read_archive_confined(int fd, ArchiveFormat format,
                           const ArchiveLimits& limits, unsigned cpu_seconds,
                           const MostBytes& most_bytes, const TakeEntry& take);

}  // namespace grader
