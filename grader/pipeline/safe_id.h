// Names of files and folders of our own for students whose names are data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

/// A name that may be used for a file on every system: 1 to 60 characters out
/// of A-Z a-z 0-9 . _ -, beginning and ending with a letter or digit, and no
/// reserved word. A name that is already so stays as it is; of any other the
/// harmless characters are kept and a hash of the whole is added.
std::string safe_id(std::string_view name);

/// An id for each name, in their order. No two are equal, even where a file
/// system takes capitals and small letters for the same. An id depends on the
/// other names only where two collide, and is never that of another student.
/// Precondition: the names are distinct.
std::vector<std::string> safe_ids(const std::vector<std::string>& names);

}  // namespace grader
