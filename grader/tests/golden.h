// Golden files of the grader's tests, and a matcher.
#pragma once

#include <string>

#include "course/tests/golden.h"

namespace grader::tests {

using course::tests::file_contents;
using course::tests::first_difference;

/// Matches a text that contains `part`; its name differs between the versions.
inline auto Containing(const std::string& part) {
#if COURSE_CATCH2 == 2
    return Catch::Matchers::Contains(part);
#else
    return Catch::Matchers::ContainsSubstring(part);
#endif
}

inline void check_golden(const std::string& name, const std::string& got) {
    course::tests::check_golden("grader/tests/golden", name, got);
}

}  // namespace grader::tests
