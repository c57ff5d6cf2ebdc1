// Letters of ASCII, whatever the locale: extensions, headers of tables, names.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace course {

/// The small letter of A to Z; other characters as they are.
constexpr char ascii_lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string ascii_lower(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return ascii_lower(c); });
    return lower;
}

}  // namespace course
