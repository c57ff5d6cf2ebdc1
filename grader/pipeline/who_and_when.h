// Who does something, and when: for what is written down for good.
#pragma once

#include <string>

namespace grader {

/// The name of the account that this process runs as; "user 1000" where the
/// system knows no name.
std::string user_name();

/// This moment as "2026-12-11T22:59:00Z".
std::string utc_now();

}  // namespace grader
