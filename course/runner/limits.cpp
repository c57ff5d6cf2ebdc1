#include "course/runner/limits.h"

#include <fmt/format.h>

#include <bit>
#include <sstream>

namespace course {

std::string limits_file(const std::map<std::string, Limits>& limits) {
    std::string text;
    for (const auto& [name, of_it] : limits)
        text += fmt::format("{} {}\n", name,
                            fmt::join(std::bit_cast<LimitNumbers>(of_it), " "));
    return text;
}

std::map<std::string, Limits> read_limits_file(const std::string& text) {
    std::map<std::string, Limits> limits;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        words >> name;
        LimitNumbers numbers{};
        for (std::int32_t& number : numbers) words >> number;
        if (words && words.eof()) limits[name] = std::bit_cast<Limits>(numbers);
    }
    return limits;
}

}  // namespace course
