// What a zip file's own directory says of its entries. libarchive takes names
// from the local headers, ends them at a NUL and composes accents, and does
// not see where the two places disagree; this does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/pipeline/file_time.h"

namespace grader {

struct ZipEntry {
    std::uint64_t offset = 0;  ///< of its local header
    std::uint64_t end = 0;     ///< behind its compressed bytes
    std::uint64_t size = 0;    ///< inflated, as it says
    std::string name;          ///< any bytes
    bool encrypted = false;
    /// By its field of times in UTC where it has one, else by the local clock.
    std::optional<FileTime> modified = {};
};

/// The entries, ordered by their local headers, as libarchive reads them.
/// Throws ArchiveError when there are more than `most`, when the directory is
/// broken or not at the file's end, when a local header says anything else, or
/// when entries overlap.
std::vector<ZipEntry> zip_directory(int fd, std::uint64_t most);

}  // namespace grader
