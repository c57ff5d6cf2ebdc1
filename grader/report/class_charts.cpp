#include "grader/report/class_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "course/report/text.h"
#include "grader/pipeline/lateness.h"

namespace grader {

namespace {

using course::append;
using course::markup;
using std::chrono::hours;

// In units of the drawing, which is about as wide as a phone.
constexpr double width = 420;
constexpr double height = 150;  // of the tallest bar
constexpr double top = 18;      // for the number above it
constexpr std::size_t most_bars = 62;

struct Bar {
    int count = 0;
    int accepted = 0;   ///< of these; drawn darker
    std::string label;  ///< below the bar; may be empty
};

Html column(const Bar& bar, double x, double wide, int tallest) {
    const double unit = tallest > 0 ? height / tallest : 0;
    const double all = bar.count * unit, dark = bar.accepted * unit;
    const double base = top + height;
    Html drawn =
        markup(R"(<rect class="part" x="{:.1f}" y="{:.1f}" width="{:.1f}" )"
               R"(height="{:.1f}"/><rect class="fill" x="{:.1f}" y="{:.1f}" )"
               R"(width="{:.1f}" height="{:.1f}"/>)",
               x, base - all, wide, all, x, base - dark, wide, dark);
    const double middle = x + wide / 2;
    if (bar.count > 0 && wide > 12)
        append(drawn, R"(<text class="count" x="{:.1f}" y="{:.1f}">{}</text>)",
               middle, base - all - 5, bar.count);
    if (!bar.label.empty())
        append(drawn, R"(<text class="axis" x="{:.1f}" y="{:.1f}">{}</text>)",
               middle, base + 16, bar.label);
    drawn.text += "\n";
    return drawn;
}

Html columns(const std::vector<Bar>& bars, std::string_view what) {
    int tallest = 0;
    for (const Bar& bar : bars) tallest = std::max(tallest, bar.count);
    const double step = width / static_cast<double>(bars.size());
    Html drawn;
    const double wide = std::min(step * 0.84, 46.0);
    for (std::size_t k = 0; k < bars.size(); ++k)
        drawn +=
            column(bars[k], (static_cast<double>(k) + 0.5) * step - wide / 2,
                   wide, tallest);
    return markup(
        R"(<svg class="columns" viewBox="0 0 {:.0f} {:.0f}" role="img" )"
        R"(aria-label="{}">)"
        "\n{}"
        R"(<line class="base" x1="0" x2="{:.0f}" y1="{:.0f}" y2="{:.0f}"/>)"
        "</svg>\n",
        width, top + height + 22, what, drawn, width, top + height,
        top + height);
}

// ---- attempts over time

struct Unit {
    hours length;
    std::string_view name;
};

constexpr std::array<Unit, 3> units = {
    {{hours(1), "hour"}, {hours(24), "day"}, {hours(24 * 7), "week"}}};

std::size_t bars_of(const Unit& unit, Instant first, Instant last) {
    return static_cast<std::size_t>((last - first) / unit.length) + 1;
}

/// The beginning of the hour, or of the day in UTC.
Instant begin_of(Instant instant, const Unit& unit) {
    const hours step = std::min(unit.length, hours(24));
    return Instant(instant.time_since_epoch() / step * step);
}

/// "11-27 09h", "11-27".
std::string label(Instant instant, const Unit& unit) {
    const std::string text = text_of(instant);
    const std::string day = text.substr(5, 5);
    return unit.length < hours(24) ? day + " " + text.substr(11, 2) + "h" : day;
}

Html timeline(const std::vector<AttemptTime>& attempts, const Unit& unit) {
    const Instant first = begin_of(attempts.front().when, unit);
    std::vector<Bar> bars(bars_of(unit, first, attempts.back().when));
    for (const AttemptTime& one : attempts) {
        Bar& bar =
            bars[static_cast<std::size_t>((one.when - first) / unit.length)];
        ++bar.count;
        if (one.accepted) ++bar.accepted;
    }
    // As many labels as can be read beside each other.
    const std::size_t step = (bars.size() + 5) / 6;
    for (std::size_t k = step / 2; k < bars.size(); k += step)
        bars[k].label = label(first + unit.length * static_cast<long>(k), unit);
    return markup(
        R"(<figure><figcaption>{} attempts, by {} in UTC; dark: accepted)"
        "</figcaption>\n{}</figure>\n",
        attempts.size(), unit.name, columns(bars, "Attempts over time"));
}

}  // namespace

Html distribution_chart(const std::vector<double>& shares) {
    std::vector<Bar> bars(10);
    for (std::size_t k = 0; k < bars.size(); ++k)
        bars[k].label = fmt::format("{}–{}", 10 * k, 10 * (k + 1));
    for (const double share : shares) {
        const auto tenth =
            static_cast<std::size_t>(std::clamp(share * 10 + 1e-9, 0.0, 9.0));
        ++bars[tenth].count;
        ++bars[tenth].accepted;
    }
    return markup(
        "<figure><figcaption>Students by their total, in % of the points"
        "</figcaption>\n{}</figure>\n",
        columns(bars, "Distribution of totals"));
}

Html timeline_chart(std::vector<AttemptTime> attempts) {
    if (attempts.empty()) return {};
    std::sort(attempts.begin(), attempts.end(),
              [](const auto& a, const auto& b) { return a.when < b.when; });
    const Instant first = attempts.front().when, last = attempts.back().when;
    for (const Unit& unit : units)
        if (bars_of(unit, begin_of(first, unit), last) <= most_bars)
            return timeline(attempts, unit);
    // Years: the newest weeks.
    const Instant from = last - units.back().length * (most_bars - 1);
    std::erase_if(attempts,
                  [&](const AttemptTime& one) { return one.when < from; });
    return timeline(attempts, units.back());
}

Html outcome_bar(int accepted, int partly, int failed, int all) {
    const double unit = all > 0 ? 100.0 / all : 0;
    const double a = accepted * unit, b = partly * unit, c = failed * unit;
    return markup(
        R"(<svg class="outcome" viewBox="0 0 100 10" )"
        R"(preserveAspectRatio="none" role="img" aria-label="{} accepted, )"
        R"({} with some points, {} without, of {}">)"
        R"(<rect class="fill" x="0" y="0" width="{:.1f}" height="10"/>)"
        R"(<rect class="part" x="{:.1f}" y="0" width="{:.1f}" height="10"/>)"
        R"(<rect class="lost" x="{:.1f}" y="0" width="{:.1f}" height="10"/>)"
        "</svg>",
        accepted, partly, failed, all, a, a, b, a + b, c);
}

}  // namespace grader
