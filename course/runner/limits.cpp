#include "course/runner/limits.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <sstream>

namespace course {

namespace {

/// Limits in their order.
using Numbers = std::array<std::int32_t, sizeof(Limits) / sizeof(std::int32_t)>;

}  // namespace

std::string limits_file(const std::map<std::string, Limits>& limits) {
    std::string text;
    for (const auto& [name, of_it] : limits)
        text += fmt::format("{} {}\n", name,
                            fmt::join(std::bit_cast<Numbers>(of_it), " "));
    return text;
}

std::map<std::string, Limits> read_limits_file(const std::string& text) {
    std::map<std::string, Limits> limits;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        Numbers numbers{};
        for (std::int32_t& number : numbers) words >> number;
        if (words && words.eof()) limits[name] = std::bit_cast<Limits>(numbers);
    }
    return limits;
}

}  // namespace course
