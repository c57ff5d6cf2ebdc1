#include "grader/pipeline/assignment_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "course/runner/nearest.h"

namespace grader {

namespace {

constexpr double largest_weight = 1000;

template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

constexpr std::array<Named<FeedbackLevel>, 3> levels = {{
    {"names", FeedbackLevel::names},
    {"names_and_hints", FeedbackLevel::names_and_hints},
    {"full", FeedbackLevel::full},
}};

constexpr std::array<Named<LatePolicy::Kind>, 3> policies = {{
    {"none", LatePolicy::Kind::none},
    {"percent_per_day", LatePolicy::Kind::percent_per_day},
    {"refuse", LatePolicy::Kind::refuse},
}};

/// "the text 'soon'", "a table": what stands where something else should.
std::string found(const toml::node& node) {
    if (const auto* text = node.as_string())
        return fmt::format("the text '{}'", text->get());
    if (const auto* number = node.as_integer())
        return fmt::format("{}", number->get());
    if (const auto* number = node.as_floating_point())
        return fmt::format("{}", number->get());
    if (const auto* truth = node.as_boolean())
        return truth->get() ? "true" : "false";
    if (node.is_array()) return "a list";
    if (node.is_table()) return "a table";
    return "a date or a time";
}

template <class List>
std::vector<std::string> names_in(const List& list) {
    std::vector<std::string> names;
    for (const auto& one : list) names.emplace_back(one.name);
    return names;
}

template <class List>
auto find_named(const List& list, std::string_view name) {
    return std::find_if(list.begin(), list.end(),
                        [&](const auto& one) { return one.name == name; });
}

}  // namespace

const std::array<AssignmentReader::Key, 10> AssignmentReader::keys = {{
    {"name", &AssignmentReader::read_name},
    {"exercises", &AssignmentReader::read_exercises},
    {"bonus", &AssignmentReader::read_bonus},
    {"hidden_feedback", &AssignmentReader::read_feedback},
    {"due", &AssignmentReader::read_due},
    {"time_zone", &AssignmentReader::read_time_zone},
    {"late", &AssignmentReader::read_late},
    {"limits", &AssignmentReader::read_limits},
    {"rounding", &AssignmentReader::read_rounding},
    {"teams", &AssignmentReader::read_teams},
}};

const std::array<AssignmentReader::Key, 2> AssignmentReader::feedback_keys = {{
    {"before_due", &AssignmentReader::read_before_due},
    {"after_due", &AssignmentReader::read_after_due},
}};

const std::array<AssignmentReader::Key, 5> AssignmentReader::late_keys = {{
    {"policy", &AssignmentReader::read_policy},
    {"percent_per_day", &AssignmentReader::read_percent},
    {"grace_minutes", &AssignmentReader::read_grace},
    {"free_days", &AssignmentReader::read_free_days},
    {"last_day", &AssignmentReader::read_last_day},
}};

const std::array<AssignmentReader::Key, 5> AssignmentReader::limit_keys = {{
    {"call_seconds", &AssignmentReader::read_call_limit},
    {"cpu_seconds", &AssignmentReader::read_cpu_limit},
    {"case_seconds", &AssignmentReader::read_case_limit},
    {"all_seconds", &AssignmentReader::read_all_limit},
    {"memory_mib", &AssignmentReader::read_memory_limit},
}};

void AssignmentReader::read(const toml::table& file) {
    read_keys(file, "", keys);
    if (file.get("exercises") == nullptr)
        wrong({},
              "no table [exercises] was found; expected one with a line such "
              "as face_sides = 1 for each exercise");
    set_due();
    check_late(file);
    set_limits();
    sort();
}

void AssignmentReader::wrong(const toml::source_position& at,
                             std::string what) {
    mistakes.push_back({static_cast<int>(at.line), static_cast<int>(at.column),
                        std::move(what)});
}

void AssignmentReader::wrong(const toml::node& node, std::string_view name,
                             std::string_view expected) {
    wrong(node.source().begin,
          fmt::format("{} is {}; expected {}", name, found(node), expected));
}

template <std::size_t N>
void AssignmentReader::read_keys(const toml::table& table, std::string_view of,
                                 const std::array<Key, N>& known) {
    for (const auto& [key, value] : table) read_key(key, value, of, known);
}

template <std::size_t N>
void AssignmentReader::read_key(const toml::key& key, const toml::node& value,
                                std::string_view of,
                                const std::array<Key, N>& known) {
    const auto one = find_named(known, key.str());
    if (one != known.end()) return (this->*one->read)(value);
    const std::vector<std::string> names = names_in(known);
    wrong(key.source().begin,
          fmt::format("'{}' is not a key{}; expected one of {}{}", key.str(),
                      of, fmt::join(names, ", "),
                      course::did_you_mean(key.str(), names)));
}

template <class List>
auto AssignmentReader::choice(const toml::node& node, std::string_view name,
                              const List& list)
    -> std::optional<decltype(list[0].value)> {
    const auto text = node.value<std::string_view>();
    const auto one = find_named(list, text.value_or(""));
    if (one != list.end()) return one->value;
    const std::vector<std::string> names = names_in(list);
    wrong(node, name,
          fmt::format("\"{}\"{}", fmt::join(names, "\", \""),
                      course::did_you_mean(text.value_or(""), names)));
    return std::nullopt;
}

std::optional<double> AssignmentReader::number(const toml::node& node,
                                               std::string_view name,
                                               double above, double most) {
    const auto value = node.value<double>();
    if (value && *value > above && *value <= most) return value;
    wrong(node, name,
          fmt::format("a number above {} and at most {}", above, most));
    return std::nullopt;
}

std::optional<int> AssignmentReader::count(const toml::node& node,
                                           std::string_view name, int least,
                                           int most) {
    const auto* value = node.as_integer();
    if (value != nullptr && value->get() >= least && value->get() <= most)
        return static_cast<int>(value->get());
    wrong(node, name, fmt::format("a whole number from {} to {}", least, most));
    return std::nullopt;
}

void AssignmentReader::read_name(const toml::node& value) {
    const auto* text = value.as_string();
    if (text != nullptr && !text->get().empty())
        assignment.name = text->get();
    else
        wrong(value, "name", "a title in quotes");
}

// ---- exercises

void AssignmentReader::read_exercises(const toml::node& value) {
    read_weights(value, "exercises", false);
}

void AssignmentReader::read_bonus(const toml::node& value) {
    read_weights(value, "bonus", true);
}

void AssignmentReader::read_weights(const toml::node& value,
                                    std::string_view name, bool is_bonus) {
    const auto* table = value.as_table();
    if (table == nullptr)
        return wrong(value, name, "a table with a weight for each exercise");
    if (table->empty())
        wrong(
            value.source().begin,
            fmt::format("[{}] is empty; expected at least one exercise", name));
    for (const auto& [key, weight] : *table)
        read_exercise(key, weight, is_bonus);
}

void AssignmentReader::read_exercise(const toml::key& key,
                                     const toml::node& weight, bool is_bonus) {
    const auto exercise = known_exercise(key.str());
    if (!exercise)
        wrong(key.source().begin,
              fmt::format("'{}' is not an exercise; expected one of the {} "
                          "there are{}",
                          key.str(), known_.size(), suggestion(key.str())));
    const auto times = number(weight, "the weight", 0, largest_weight);
    if (exercise && times)
        placed_.push_back({key.source().begin, {*exercise, *times, is_bonus}});
}

std::optional<std::string> AssignmentReader::known_exercise(
    std::string_view name) const {
    for (const std::string& exercise : known_)
        if (exercise == name || short_name(exercise) == name) return exercise;
    return std::nullopt;
}

std::string AssignmentReader::suggestion(std::string_view name) const {
    std::vector<std::string> names = known_;
    if (chapter(name).empty())
        for (std::string& one : names) one = short_name(one);
    return course::did_you_mean(name, names);
}

// ---- feedback

void AssignmentReader::read_feedback(const toml::node& value) {
    if (const auto* table = value.as_table())
        return read_keys(*table, " of [hidden_feedback]", feedback_keys);
    read_before_due(value);
    assignment.hidden_feedback.after_due =
        assignment.hidden_feedback.before_due;
}

void AssignmentReader::read_before_due(const toml::node& value) {
    if (const auto level = choice(value, "hidden_feedback", levels))
        assignment.hidden_feedback.before_due = *level;
}

void AssignmentReader::read_after_due(const toml::node& value) {
    if (const auto level = choice(value, "hidden_feedback", levels))
        assignment.hidden_feedback.after_due = *level;
}

// ---- dates

void AssignmentReader::read_due(const toml::node& value) {
    const auto* time = value.as_date_time();
    if (time == nullptr || time->get().offset)
        return wrong(value, "due",
                     "a local date and time such as 2026-12-11T23:59:00, and "
                     "its time_zone");
    std::ostringstream text;
    text << time->get();
    due_ = {value.source().begin, text.str()};
}

void AssignmentReader::read_time_zone(const toml::node& value) {
    const auto* text = value.as_string();
    if (text == nullptr)
        return wrong(value, "time_zone", "a name such as \"Europe/Rome\"");
    zone_ = {value.source().begin, text->get()};
    try {
        instant_of("2026-01-01T12:00:00", zone_.text);
    } catch (const TimeError& error) {
        wrong(zone_.at, error.what());
        zone_.text.clear();
    }
}

void AssignmentReader::set_due() {
    if (due_.text.empty() || zone_.text.empty()) return;
    try {
        assignment.due = {instant_of(due_.text, zone_.text), zone_.text};
    } catch (const TimeError& error) {
        wrong(due_.at, error.what());
    }
}

// ---- late work

void AssignmentReader::read_late(const toml::node& value) {
    if (const auto* table = value.as_table())
        read_keys(*table, " of [late]", late_keys);
    else
        wrong(value, "late", "a table [late] with its policy");
}

void AssignmentReader::read_policy(const toml::node& value) {
    if (const auto kind = choice(value, "policy", policies))
        assignment.late.kind = *kind;
}

void AssignmentReader::read_percent(const toml::node& value) {
    assignment.late.percent_per_day =
        number(value, "percent_per_day", 0, 100).value_or(0);
}

void AssignmentReader::read_grace(const toml::node& value) {
    assignment.late.grace_minutes =
        count(value, "grace_minutes", 0, 1440).value_or(0);
}

void AssignmentReader::read_free_days(const toml::node& value) {
    assignment.late.free_days = count(value, "free_days", 0, 365).value_or(0);
}

void AssignmentReader::read_last_day(const toml::node& value) {
    assignment.late.last_day = count(value, "last_day", 1, 365);
}

/// What only together makes sense.
void AssignmentReader::check_late(const toml::table& file) {
    const toml::node* late = file.get("late");
    if (late == nullptr || !late->is_table()) return;
    const toml::source_position at = late->source().begin;
    if (file.get("due") == nullptr)
        wrong(at,
              "[late] stands without a due date; expected due = and a "
              "date and time above it");
    const toml::table& table = *late->as_table();
    if (table.get("policy") == nullptr)
        wrong(at,
              "[late] has no policy; expected one of none, "
              "percent_per_day, refuse");
    const bool by_day =
        assignment.late.kind == LatePolicy::Kind::percent_per_day;
    if (by_day != (table.get("percent_per_day") != nullptr))
        wrong(at, by_day ? "[late] has no percent_per_day; expected how many "
                           "percent a day takes off"
                         : "[late] has percent_per_day; expected it with "
                           "policy = \"percent_per_day\" only");
}

// ---- limits

/// toml++ keeps keys by alphabet: those of all exercises come first, since the
/// exercises' own tables go on from them.
void AssignmentReader::read_limits(const toml::node& value) {
    const auto* table = value.as_table();
    if (table == nullptr)
        return wrong(value, "limits", "a table such as [limits]");
    for (const auto& [key, limit] : *table)
        if (!limit.is_table()) read_key(key, limit, " of [limits]", limit_keys);
    check_limits(*table);
    common_limits_ = limits_;
    for (const auto& [key, own] : *table)
        if (own.is_table()) read_limits_of(key, *own.as_table());
}

void AssignmentReader::read_limits_of(const toml::key& exercise,
                                      const toml::table& table) {
    const std::string_view name = exercise.str();
    const auto known = known_exercise(name);
    if (!known)
        return wrong(exercise.source().begin,
                     fmt::format("'{}' is not an exercise; expected one of the "
                                 "{} there are{}",
                                 name, known_.size(), suggestion(name)));
    limits_ = common_limits_;
    read_keys(table, fmt::format(" of [limits.{}]", name), limit_keys);
    check_limits(table);
    own_limits_.push_back({exercise.source().begin, *known, limits_});
}

/// Whole ones of a number of seconds.
std::optional<std::int32_t> AssignmentReader::milliseconds(
    const toml::node& node, std::string_view name, int most) {
    const auto seconds = number(node, name, 0.01, most);
    if (!seconds) return std::nullopt;
    return static_cast<std::int32_t>(*seconds * 1000);
}

void AssignmentReader::read_call_limit(const toml::node& value) {
    const auto ms = milliseconds(value, "call_seconds", 60);
    if (!ms) return;
    limits_.call_ms = *ms;
    limits_.later_call_ms = *ms / 10;
}

void AssignmentReader::read_cpu_limit(const toml::node& value) {
    const auto ms = milliseconds(value, "cpu_seconds", 60);
    if (!ms) return;
    limits_.cpu_ms = *ms;
    limits_.later_cpu_ms = *ms * 2 / 5;
}

/// The system counts a case's CPU time in whole seconds.
void AssignmentReader::read_case_limit(const toml::node& value) {
    const auto ms = milliseconds(value, "case_seconds", 600);
    if (!ms) return;
    limits_.case_ms = *ms;
    limits_.cpu_seconds = (*ms * 4 / 5 + 999) / 1000;
}

void AssignmentReader::read_all_limit(const toml::node& value) {
    limits_.run_ms =
        milliseconds(value, "all_seconds", 3600).value_or(limits_.run_ms);
}

void AssignmentReader::read_memory_limit(const toml::node& value) {
    limits_.memory_mib =
        count(value, "memory_mib", 64, 16'384).value_or(limits_.memory_mib);
}

/// A limit that lies above the one around it would never be met.
void AssignmentReader::check_limits(const toml::table& table) {
    const auto check = [&](std::string_view inner, std::int32_t inner_ms,
                           std::string_view outer, std::int32_t outer_ms) {
        const toml::node* given = table.get(inner);
        if (given != nullptr && inner_ms > outer_ms)
            wrong(
                *given, inner,
                fmt::format("at most the {} of {}", outer_ms / 1000.0, outer));
    };
    check("call_seconds", limits_.call_ms, "case_seconds", limits_.case_ms);
    check("cpu_seconds", limits_.cpu_ms, "case_seconds", limits_.case_ms);
    check("case_seconds", limits_.case_ms, "all_seconds", limits_.run_ms);
}

void AssignmentReader::set_limits() {
    for (Placed& one : placed_) one.item.limits = common_limits_;
    for (const PlacedLimits& own : own_limits_) {
        const auto is_it = [&](const Placed& one) {
            return one.item.exercise == own.exercise;
        };
        const auto found = std::find_if(placed_.begin(), placed_.end(), is_it);
        if (found != placed_.end())
            found->item.limits = own.limits;
        else
            wrong(own.at,
                  fmt::format("{} has limits, but is not of this assignment; "
                              "expected an exercise that is",
                              own.exercise));
    }
}

// ---- totals

void AssignmentReader::read_rounding(const toml::node& value) {
    assignment.rounding = number(value, "rounding", 0, 10).value_or(0);
}

void AssignmentReader::read_teams(const toml::node& value) {
    if (const auto* truth = value.as_boolean())
        assignment.in_teams = truth->get();
    else
        wrong(value, "teams", "true or false");
}

// ---- order

/// toml++ keeps keys by alphabet; reports follow the file.
void AssignmentReader::sort() {
    const auto by_place = [](const auto& a, const auto& b) {
        return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    };
    std::sort(
        placed_.begin(), placed_.end(),
        [&](const Placed& a, const Placed& b) { return by_place(a.at, b.at); });
    for (const Placed& one : placed_) add(one);
    std::stable_sort(mistakes.begin(), mistakes.end(), by_place);
}

void AssignmentReader::add(const Placed& one) {
    for (const Assignment::Item& item : assignment.exercises)
        if (item.exercise == one.item.exercise)
            return wrong(one.at,
                         fmt::format("{} is named a second time; expected each "
                                     "exercise once",
                                     item.exercise));
    assignment.exercises.push_back(one.item);
}

}  // namespace grader
