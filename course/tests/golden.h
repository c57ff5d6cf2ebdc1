// Golden files: what people read is compared with a copy that a person has
// looked at. UPDATE_GOLDEN=1 in the environment writes the copies anew.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "course/runner/catch2.h"

namespace course::tests {

inline std::string file_contents(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// "line 3: expected ..., got ...": where two texts part.
inline std::string first_difference(const std::string& expected,
                                    const std::string& got) {
    std::istringstream a(expected), b(got);
    std::string x, y;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(a, x));
        const bool more_b = static_cast<bool>(std::getline(b, y));
        if (!more_a && !more_b) return "only the ends differ";
        if (more_a != more_b || x != y)
            return "line " + std::to_string(line) +
                   "\n  expected: " + (more_a ? x : "(the end)") +
                   "\n  got:      " + (more_b ? y : "(the end)");
    }
}

/// Compares with a file of that folder, which is named from the root.
inline void check_golden(const std::filesystem::path& folder,
                         const std::string& name, const std::string& got) {
    const std::filesystem::path file =
        std::filesystem::path(COURSE_SOURCE_DIR) / folder / name;
    const char* update = std::getenv("UPDATE_GOLDEN");
    if (update != nullptr && std::string(update) == "1") {
        std::ofstream(file, std::ios::binary) << got;
        return;
    }
    const std::string expected = file_contents(file);
    INFO(name << ", " << first_difference(expected, got));
    CHECK((expected == got));
}

}  // namespace course::tests
