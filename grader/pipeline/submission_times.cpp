#include "grader/pipeline/submission_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace grader {

namespace {

constexpr std::size_t most_names_in_a_note = 10;

/// What the clocks of the zone show at that moment may not exist, in the night
/// when they are put forward: then the same hour of the old clocks.
Instant instant_of_file(const FileTime& time, const std::string& zone) {
    const Instant as_utc{std::chrono::seconds(time.seconds)};
    if (!time.is_local) return as_utc;
    std::string text = text_of(as_utc);
    text.pop_back();  // its Z
    try {
        return instant_of(text, zone);
    } catch (const TimeError&) {
        std::string before = text_of(as_utc - std::chrono::hours(1));
        before.pop_back();
        return instant_of(before, zone) + std::chrono::hours(1);
    }
}

bool belongs_to(const Submission& one, const std::string& who) {
    return is_named(one, who) ||
           std::any_of(one.members.begin(), one.members.end(),
                       [&](const Member& member) {
                           return !who.empty() &&
                                  (member.name == who || member.number == who ||
                                   member.email == who);
                       });
}

/// The columns of a table that this can read.
struct TimeColumns {
    std::size_t who = 0, time = 1, first_row = 1;
    std::optional<std::size_t> group, name, email;
    bool is_worksheet = false;
};

bool is_time(const std::string& text, const std::string& zone) {
    try {
        instant_in(text, zone);
        return true;
    } catch (const TimeError&) {
        return false;
    }
}

TimeColumns columns_of(const CsvTable& table, const std::string& zone) {
    TimeColumns columns;
    const auto time = column_named(table, "Last modified (submission)");
    const auto who = column_named(table, "Identifier");
    if (time && who) {
        columns.who = *who;
        columns.time = *time;
        columns.group = column_named(table, "Group");
        columns.name = column_named(table, "Full name");
        columns.email = column_named(table, "Email address");
        columns.is_worksheet = true;
    } else if (table.columns() == 2) {
        columns.first_row = is_time(table.value(0, 1), zone) ? 0 : 1;
    } else {
        throw CsvError(
            "is no table of times; expected two columns, of names or numbers "
            "and of times, or Moodle's grading worksheet with Identifier and "
            "Last modified (submission)");
    }
    return columns;
}

class TimeTable {
public:
    TimeTable(const CsvTable& table, const std::string& zone, bool in_teams,
              SubmittedClass& submitted)
        : table_(table),
          zone_(zone),
          columns_(columns_of(table, zone)),
          in_teams_(in_teams && columns_.group.has_value()),
          submitted_(submitted) {}

    void take() {
        for (std::size_t row = columns_.first_row; row < table_.rows(); ++row)
            take_row(row);
    }

private:
    std::string cell(std::size_t row, std::optional<std::size_t> column) const {
        return column ? table_.value(row, *column) : "";
    }

    void note(std::size_t row, const std::string& text) {
        submitted_.notes.push_back(
            fmt::format("times, line {}: {}", table_.line(row), text));
    }

    /// "1234" of Moodle's "Participant 1234"; any other text as it is.
    std::string who(std::size_t row) const {
        const std::string text = table_.value(row, columns_.who);
        return columns_.is_worksheet ? text.substr(text.rfind(' ') + 1) : text;
    }

    std::vector<Submission*> submissions_of(const std::string& who) {
        std::vector<Submission*> all;
        for (Submission& one : submitted_.submissions)
            if (belongs_to(one, who)) all.push_back(&one);
        return all;
    }

    void take_row(std::size_t row) {
        const std::string group = in_teams_ ? cell(row, columns_.group) : "";
        const std::string whose = group.empty() ? who(row) : group;
        const std::vector<Submission*> found = submissions_of(whose);
        const std::string time = table_.value(row, columns_.time);
        // A worksheet has a row for those, too, who handed in nothing.
        const bool is_empty =
            columns_.is_worksheet && (time.empty() || time == "-");
        if (found.size() != 1) {
            if (!is_empty)
                note(row, fmt::format("{} is the name of {} submissions; "
                                      "expected one",
                                      whose, found.size()));
            return;
        }
        Submission& one = *found[0];
        if (!group.empty())
            one.members.push_back({cell(row, columns_.name), who(row),
                                   cell(row, columns_.email)});
        if (!is_empty) take_time(row, time, one);
    }

    void take_time(std::size_t row, const std::string& time, Submission& one) {
        try {
            one.submitted_at = instant_in(time, zone_);
        } catch (const TimeError& error) {
            note(row, error.what());
        }
    }

    const CsvTable& table_;
    const std::string& zone_;
    TimeColumns columns_;
    bool in_teams_;
    SubmittedClass& submitted_;
};

}  // namespace

void take_times_of_files(SubmittedClass& submitted, const std::string& zone) {
    for (Submission& one : submitted.submissions) {
        if (one.submitted_at) continue;
        for (const FileTime& time : one.modified)
            one.submitted_at = std::max(
                one.submitted_at, std::optional(instant_of_file(time, zone)));
    }
}

void take_times_from(const CsvTable& table, const std::string& zone,
                     bool in_teams, SubmittedClass& submitted) {
    TimeTable(table, zone, in_teams, submitted).take();
}

void note_missing_times(SubmittedClass& submitted) {
    std::vector<std::string> names;
    for (const Submission& one : submitted.submissions)
        if (!one.submitted_at) names.push_back(one.student);
    if (names.empty()) return;
    const std::size_t more =
        names.size() - std::min(names.size(), most_names_in_a_note);
    names.resize(names.size() - more);
    submitted.notes.push_back(fmt::format(
        "when it came is not known, and so it counts as in time: {}{}",
        fmt::join(names, ", "),
        more > 0 ? fmt::format(" and {} more", more) : ""));
}

}  // namespace grader
