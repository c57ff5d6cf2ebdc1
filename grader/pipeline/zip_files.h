// Zip archives that we hand out.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace grader {

/// The bytes of an archive of regular files: their names in it, and where they
/// are. Whether they may be run is kept; all are dated 1980-01-01, so that the
/// same files give the same archive. All of it is in memory. Throws
/// course::SystemError when a file cannot be read.
std::string zip_of_files(
    const std::map<std::string, std::filesystem::path>& files);

/// Every file below `folder`, to be packed under `name`/.
std::map<std::string, std::filesystem::path> files_to_pack(
    const std::filesystem::path& folder, const std::string& name);

}  // namespace grader
