// Reads one parsed assignment file: keeps what is right, notes what is wrong.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/pipeline/assignment.h"

namespace grader {

class AssignmentReader {
public:
    /// `known`: see read_assignment.
    explicit AssignmentReader(const std::vector<std::string>& known)
        : known_(known) {}

    void read(const toml::table& file);

    Assignment assignment;
    std::vector<AssignmentMistake> mistakes;  ///< in the order of the file

private:
    /// What a key of the file is read by.
    struct Key {
        std::string_view name;
        void (AssignmentReader::*read)(const toml::node&);
    };
    static const std::array<Key, 10> keys;
    static const std::array<Key, 2> feedback_keys;
    static const std::array<Key, 5> late_keys;
    static const std::array<Key, 5> limit_keys;

    struct Placed {
        toml::source_position at;
        Assignment::Item item;
    };
    struct PlacedLimits {
        toml::source_position at;
        std::string exercise;
        course::Limits limits;
    };
    struct PlacedText {
        toml::source_position at;
        std::string text;
    };

    void wrong(const toml::source_position& at, std::string what);
    void wrong(const toml::node& node, std::string_view name,
               std::string_view expected);

    template <std::size_t N>
    void read_keys(const toml::table& table, std::string_view of,
                   const std::array<Key, N>& known);
    template <std::size_t N>
    void read_key(const toml::key& key, const toml::node& value,
                  std::string_view of, const std::array<Key, N>& known);
    template <class List>
    auto choice(const toml::node& node, std::string_view name, const List& list)
        -> std::optional<decltype(list[0].value)>;
    std::optional<double> number(const toml::node& node, std::string_view name,
                                 double above, double most);
    std::optional<int> count(const toml::node& node, std::string_view name,
                             int least, int most);

    void read_name(const toml::node& value);
    void read_exercises(const toml::node& value);
    void read_bonus(const toml::node& value);
    void read_weights(const toml::node& value, std::string_view name,
                      bool is_bonus);
    void read_exercise(const toml::key& key, const toml::node& weight,
                       bool is_bonus);
    std::optional<std::string> known_exercise(std::string_view name) const;
    std::string suggestion(std::string_view name) const;
    void read_feedback(const toml::node& value);
    void read_before_due(const toml::node& value);
    void read_after_due(const toml::node& value);
    void read_due(const toml::node& value);
    void read_time_zone(const toml::node& value);
    void set_due();
    void read_late(const toml::node& value);
    void read_policy(const toml::node& value);
    void read_percent(const toml::node& value);
    void read_grace(const toml::node& value);
    void read_free_days(const toml::node& value);
    void read_last_day(const toml::node& value);
    void check_late(const toml::table& file);
    void read_limits(const toml::node& value);
    void read_limits_of(const toml::key& exercise, const toml::table& table);
    void read_call_limit(const toml::node& value);
    void read_cpu_limit(const toml::node& value);
    void read_case_limit(const toml::node& value);
    void read_all_limit(const toml::node& value);
    void read_memory_limit(const toml::node& value);
    std::optional<std::int32_t> milliseconds(const toml::node& node,
                                             std::string_view name, int most);
    void check_limits(const toml::table& table);
    void set_limits();
    void read_rounding(const toml::node& value);
    void read_teams(const toml::node& value);
    void sort();
    void add(const Placed& one);

    const std::vector<std::string>& known_;
    std::vector<Placed> placed_;
    course::Limits limits_;  ///< those that are being read
    course::Limits common_limits_;
    std::vector<PlacedLimits> own_limits_;
    PlacedText due_;
    PlacedText zone_ = {{}, "UTC"};
};

}  // namespace grader
