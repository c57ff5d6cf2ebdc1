// When work is late, by how many days, and what that leaves of its points.
#pragma once

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

namespace grader {

/// A moment, in UTC and whole seconds.
using Instant =
    std::chrono::time_point<std::chrono::system_clock, std::chrono::seconds>;

/// A time that a zone's clocks do not show, or a zone that there is not.
struct TimeError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The moment when the clocks of the zone ("Europe/Rome") show the local time
/// ("2026-12-11T23:59:00"). Of two, in the night in which clocks are put back,
/// the later one. Throws TimeError.
Instant instant_of(const std::string& local, const std::string& zone);

/// "2026-12-11T22:59:00Z" as a moment, and back. Throws TimeError.
Instant instant_of(const std::string& utc);
std::string text_of(Instant instant);

/// "2026-12-11 23:59 CET": what the clocks of the zone show. Throws TimeError.
std::string text_in(Instant instant, const std::string& zone);

/// Any of "2026-12-11T22:59:00Z", "2026-12-11 23:59:00.123 +0100",
/// "2026-12-11T23:59+01:00", or without an offset by the clocks of the zone;
/// also "Friday, 11 December 2026, 11:59 PM", as Moodle writes it in English.
/// Parts of a second are dropped. Throws TimeError.
Instant instant_in(const std::string& text, const std::string& zone);

/// What happens to work that comes after the due date.
struct LatePolicy {
    enum class Kind {
        none,             ///< it is marked as late and counts in full
        percent_per_day,  ///< each day that has begun takes off a part
        refuse,           ///< it counts nothing
    };

    Kind kind = Kind::none;
    double percent_per_day = 0;   ///< of the points that were reached
    int grace_minutes = 0;        ///< added to the due date, for everybody
    int free_days = 0;            ///< first late days that cost nothing
    std::optional<int> last_day;  ///< work of later days counts nothing

    friend bool operator==(const LatePolicy&, const LatePolicy&) = default;
};

/// When an assignment is due, by the clocks of its zone.
struct DueDate {
    Instant at;
    std::string zone;

    friend bool operator==(const DueDate&, const DueDate&) = default;
};

/// What became of one submission.
struct Lateness {
    int days = 0;       ///< that have begun since it was due; 0: in time
    double factor = 1;  ///< what is left of its points, 0 to 1

    friend bool operator==(const Lateness&, const Lateness&) = default;
};

/// A day is one on the clock: from 23:59 to 23:59, also when the clocks are
/// changed in between and it has 23 or 25 hours.
/// Throws TimeError when there is no such zone.
Lateness lateness(const DueDate& due, const LatePolicy& policy,
                  Instant submitted);

/// The multiple of `step` that is nearest to `points`; halves are rounded up,
/// as in 2.675 to 2.68. Without a step (0) what was given.
double rounded(double points, double step);

}  // namespace grader
