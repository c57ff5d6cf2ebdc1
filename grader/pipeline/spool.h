// Bytes of files that are kept on disk: those of a whole class may be more
// than a machine has memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "course/runner/descriptors.h"

namespace grader {

/// Where a spool has the bytes of one file.
struct Stored {
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
};

/// A file without a name in the system's folder for temporary files: it is gone
/// with its owner, also when the process is killed. Nothing in it is given back
/// before.
class Spool {
public:
    /// Throws course::SystemError.
    Spool();

    /// Writes the bytes behind all others, from one thread at a time. Throws
    /// course::SystemError, as when the disk is full; what was kept before
    /// stays.
    Stored keep(std::string_view bytes);

    /// What was kept there in this spool; for any number of threads at once.
    /// Throws course::SystemError.
    std::string read(const Stored& stored) const;

private:
    course::Descriptor file_;
    std::uint64_t end_ = 0;
};

}  // namespace grader
