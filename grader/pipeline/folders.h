// Folders and files by descriptor: no component of a path may be a link, and
// nothing is waited for.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/descriptors.h"
#include "grader/pipeline/file_time.h"

namespace grader {

/// Closed, with errno, where there is no such folder. Links are not followed.
course::Descriptor open_folder(int parent, const std::string& name);

/// The folder `path` ("a/b", or "" for `root` itself) below `root`.
course::Descriptor open_below(int root, std::string_view path);

struct Listing {
    std::vector<std::string> names;  ///< sorted
    bool whole = true;               ///< false: there are more
};

/// The names in a folder, at most `most` of them.
Listing names_in(int folder, std::size_t most);

enum class FileKind { file, folder, link, other, gone };

FileKind kind_of(int folder, const std::string& name);

/// A regular file of at most so many bytes, or why it was refused.
struct OpenedFile {
    course::Descriptor file;
    std::size_t size = 0;
    std::string why_not;
    std::optional<FileTime> modified = {};
};

OpenedFile open_file(int folder, const std::string& name, std::size_t most);

/// Either the bytes of a file or why it was refused.
struct ReadFile {
    std::optional<std::string> bytes;
    std::string why_not;
    std::optional<FileTime> modified = {};
};

ReadFile read_file(int folder, const std::string& name, std::size_t most);

}  // namespace grader
