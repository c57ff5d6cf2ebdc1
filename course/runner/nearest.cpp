#include "course/runner/nearest.h"

#include <algorithm>

namespace course {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the usual table: the one before the last is for swaps.
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1),
        row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced =
                last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

std::optional<std::string> nearest(std::string_view word,
                                   const std::vector<std::string>& candidates) {
    constexpr std::size_t longest = 100;  // no name of ours is longer
    if (word.size() > longest) return std::nullopt;
    std::optional<std::string> best;
    std::size_t least = 0;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (2 * distance >= std::max(word.size(), candidate.size())) continue;
        if (best && distance >= least) continue;
        best = candidate;
        least = distance;
    }
    return best;
}

std::string did_you_mean(std::string_view word,
                         const std::vector<std::string>& candidates) {
    const auto best = nearest(word, candidates);
    return best ? "; did you mean " + *best + "?" : "";
}

}  // namespace course
