// When a file was last changed, as a folder or an archive says it.
#pragma once

#include <cstdint>

namespace grader {

struct FileTime {
    /// Since 1970, in UTC; or, where `is_local`, as if the clocks that it was
    /// read from had shown UTC: zip files do not say in which zone they are.
    std::int64_t seconds = 0;
    bool is_local = false;

    friend bool operator==(const FileTime&, const FileTime&) = default;
};

}  // namespace grader
