// Zip archives of a few small text files, not compressed: enough to hand in.
#pragma once

#include <map>
#include <string>

namespace course {

/// The archive's bytes: file name to contents, dated 1980-01-01, so that the
/// same files give the same archive. (PKWARE's APPNOTE, sections 4.3 and 4.4)
/// Precondition: names in ASCII; all together below 4 GiB, 65535 files at most.
std::string zip_of(const std::map<std::string, std::string>& files);

}  // namespace course
