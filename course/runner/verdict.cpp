#include "course/runner/verdict.h"

#include <array>

namespace course {

namespace {

struct Names {
    std::string_view name;
    std::string_view words;
};

constexpr std::array<Names, 9> all_names = {{
    {"accepted", "accepted"},
    {"wrong_answer", "wrong answer"},
    {"run_time_error", "run-time error"},
    {"memory_limit_exceeded", "memory limit exceeded"},
    {"time_limit_exceeded", "time limit exceeded"},
    {"compile_error", "compile error"},
    {"forbidden_operation", "forbidden operation"},
    {"not_submitted", "not submitted"},
    {"grader_fault", "grader fault"},
}};

}  // namespace

std::string_view name(Verdict verdict) {
    return all_names.at(static_cast<std::size_t>(verdict)).name;
}

std::string_view words(Verdict verdict) {
    return all_names.at(static_cast<std::size_t>(verdict)).words;
}

std::optional<Verdict> verdict_named(std::string_view wanted) {
    for (std::size_t k = 0; k < all_names.size(); ++k)
        if (all_names[k].name == wanted) return static_cast<Verdict>(k);
    return std::nullopt;
}

}  // namespace course
