#include "grader/report/walk.h"

#include <fmt/format.h>

namespace grader {

namespace {

/// The least period of `steps` that it holds at least three times; 0 if none.
/// One step alone, of a walk of many reads, stood still.
std::size_t period(const std::vector<int>& steps) {
    if (steps.size() == 1) return 1;
    for (std::size_t p = 1; 3 * p <= steps.size(); ++p) {
        bool repeats = true;
        for (std::size_t k = p; k < steps.size() && repeats; ++k)
            repeats = steps[k] == steps[k - p];
        if (repeats) return p;
    }
    return 0;
}

}  // namespace

Walk walk_of(std::span<const Visit> visits, std::int64_t reads) {
    Walk walk;
    walk.reads = reads;
    walk.from_the_start = reads <= static_cast<std::int64_t>(visits.size());
    for (const Visit& visit : visits)
        if (walk.steps.empty() || walk.steps.back() != visit.i)
            walk.steps.push_back(visit.i);
    const std::size_t turn = walk.from_the_start ? 0 : period(walk.steps);
    if (turn > 0) {
        walk.repeats = true;
        walk.steps.resize(turn);
    }
    return walk;
}

std::string walk_text(const Walk& walk) {
    if (walk.steps.empty()) return "";
    std::string text = walk.from_the_start || walk.repeats ? "" : "... ";
    for (const int step : walk.steps) text += fmt::format("he[{}] ", step);
    if (walk.repeats) {
        text.pop_back();
        return text + fmt::format(", again and again ({} reads)", walk.reads);
    }
    if (!walk.from_the_start)
        return text +
               fmt::format("and stopped (the end of {} reads)", walk.reads);
    return text + "and stopped";
}

std::map<int, std::string> walk_order(const Walk& walk) {
    constexpr int most = 3;
    const bool numbered = walk.from_the_start || walk.repeats;
    std::map<int, std::string> order;
    std::map<int, int> times;
    int number = 0;
    for (const int step : walk.steps) {
        ++number;
        std::string& text = order[step];
        if (!numbered || ++times[step] > most + 1) continue;
        if (times[step] > most)
            text += ", ...";
        else
            text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
    }
    return order;
}

}  // namespace grader
