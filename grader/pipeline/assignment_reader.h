// Reads one parsed assignment file: keeps what is right, notes what is wrong.
#pragma once

#include <toml++/toml.h>

#include <array>
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
    static const std::array<Key, 9> keys;
    static const std::array<Key, 2> feedback_keys;
    static const std::array<Key, 5> late_keys;

    struct Placed {
        toml::source_position at;
        Assignment::Item item;
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
    void read_rounding(const toml::node& value);
    void read_teams(const toml::node& value);
    void sort();
    void add(const Placed& one);

    const std::vector<std::string>& known_;
    std::vector<Placed> placed_;
    PlacedText due_;
    PlacedText zone_ = {{}, "UTC"};
};

}  // namespace grader
