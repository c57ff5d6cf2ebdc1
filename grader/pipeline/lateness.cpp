#include "grader/pipeline/lateness.h"

#include <date/tz.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace grader {

namespace {

using date::local_seconds;

const date::time_zone& zone_of(const std::string& name) {
    try {
        return *date::locate_zone(name);
    } catch (const std::runtime_error&) {
        throw TimeError(fmt::format(
            "there is no time zone '{}'; expected one such as Europe/Rome",
            name));
    }
}

/// All of `text` by `format`.
template <class Time>
Time parsed(const std::string& text, const char* format) {
    Time time;
    std::istringstream in(text);
    in >> date::parse(format, time);
    if (in.fail() || in.peek() != std::istringstream::traits_type::eof())
        throw TimeError(
            fmt::format("'{}' is not a time; expected one such as {}", text,
                        date::format(format, date::sys_seconds{})));
    return time;
}

/// As Moodle writes it in English.
std::optional<local_seconds> moodle_time(const std::string& text) {
    local_seconds time;
    std::istringstream in(text);
    in >> date::parse("%A, %d %B %Y, %I:%M %p", time);
    if (in.fail() || in.peek() != std::istringstream::traits_type::eof())
        return std::nullopt;
    return time;
}

double factor_of(const LatePolicy& policy, int days) {
    if (policy.last_day && days > *policy.last_day) return 0;
    switch (policy.kind) {
        case LatePolicy::Kind::none:
            return 1;
        case LatePolicy::Kind::refuse:
            return 0;
        case LatePolicy::Kind::percent_per_day:
            break;
    }
    const int charged = std::max(0, days - policy.free_days);
    return std::max(0.0, 1 - charged * policy.percent_per_day / 100);
}

}  // namespace

Instant instant_of(const std::string& local, const std::string& zone) {
    const auto time = parsed<local_seconds>(local, "%FT%T");
    const auto info = zone_of(zone).get_info(time);
    if (info.result == date::local_info::nonexistent)
        throw TimeError(
            fmt::format("{} does not exist in {}: the clocks are put forward",
                        local, zone));
    return zone_of(zone).to_sys(time, date::choose::latest);
}

Instant instant_of(const std::string& utc) {
    return parsed<date::sys_seconds>(utc, "%FT%TZ");
}

Instant instant_in(const std::string& text, const std::string& zone) {
    static const std::regex form(
        R"((\d{4}-\d\d-\d\d)[T ](\d\d:\d\d)(:\d\d)?(?:\.\d{1,12})?)"
        R"( ?(?:(Z|UTC)|([+-])(\d\d):?(\d\d))?)");
    if (const auto time = moodle_time(text))
        return zone_of(zone).to_sys(*time, date::choose::latest);
    std::smatch part;
    if (text.size() > 60 || !std::regex_match(text, part, form))
        throw TimeError(
            fmt::format("'{}' is not a time; expected one such as "
                        "2026-12-11T23:59:00+01:00",
                        text));
    const std::string local = part.str(1) + "T" + part.str(2) +
                              (part[3].matched ? part.str(3) : ":00");
    if (part[4].matched) return instant_of(local + "Z");
    if (!part[5].matched) return instant_of(local, zone);
    const std::chrono::minutes offset(60 * std::stoi(part.str(6)) +
                                      std::stoi(part.str(7)));
    const Instant shown = instant_of(local + "Z");
    return part.str(5) == "-" ? shown + offset : shown - offset;
}

std::string text_of(Instant instant) {
    return date::format("%FT%TZ", instant);
}

std::string text_in(Instant instant, const std::string& zone) {
    return date::format("%F %H:%M %Z",
                        date::make_zoned(&zone_of(zone), instant));
}

Lateness lateness(const DueDate& due, const LatePolicy& policy,
                  Instant submitted) {
    const Instant last = due.at + std::chrono::minutes(policy.grace_minutes);
    if (submitted <= last) return {};
    const date::time_zone& zone = zone_of(due.zone);
    const auto late = zone.to_local(submitted) - zone.to_local(last);
    // While clocks are put back the local time of a late submission may be one
    // before that of the due date.
    const int days =
        std::max(1, static_cast<int>(date::ceil<date::days>(late).count()));
    return {days, factor_of(policy, days)};
}

double rounded(double points, double step) {
    if (step == 0) return points;
    // Decimals are not exact in binary: 2.675 / 0.01 is a little below 267.5.
    constexpr double noise = 1e-9;
    return std::floor(points / step + 0.5 + noise) * step;
}

}  // namespace grader
