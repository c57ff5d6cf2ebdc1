// The charts of the class's report: inline SVG that can be read at 390 pixels,
// in black and white, and on paper.
#pragma once

#include <vector>

#include "course/report/html.h"
#include "grader/report/class_summary.h"

namespace grader {

using course::Html;

/// How many students reached how much: a bar for each tenth of the maximum.
/// `shares` are of 1; more than 1, by a bonus, counts as the last tenth.
Html distribution_chart(const std::vector<double>& shares);

/// Attempts over time, by hours, days or weeks: whichever needs at most 62
/// bars. Nothing when there are none.
Html timeline_chart(std::vector<AttemptTime> attempts);

/// A bar of four parts, of so many of all: accepted, some points, no points,
/// the rest not handed in.
Html outcome_bar(int accepted, int partly, int failed, int all);

}  // namespace grader
