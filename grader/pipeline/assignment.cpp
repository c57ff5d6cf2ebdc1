#include "grader/pipeline/assignment.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "course/runner/nearest.h"

namespace grader {

namespace {

constexpr double largest_weight = 1000;
// A few hundred exercises. toml++ 3.3 limits the depth of lists, but not of
// dotted keys: it ends on a full stack at 32 000 of them in a row.
constexpr std::uintmax_t largest_file = 16 << 10;

const std::vector<std::string> keys = {"name", "hidden_feedback", "exercises"};

struct LevelName {
    std::string_view name;
    FeedbackLevel level;
};
constexpr std::array<LevelName, 3> levels = {{
    {"names", FeedbackLevel::names},
    {"names_and_hints", FeedbackLevel::names_and_hints},
    {"full", FeedbackLevel::full},
}};

std::string all_messages(const std::filesystem::path& file,
                         const std::vector<AssignmentMistake>& mistakes) {
    std::string text;
    for (const AssignmentMistake& mistake : mistakes) {
        if (!text.empty()) text += '\n';
        text += file.filename().string();
        if (mistake.line > 0)
            text += fmt::format(":{}:{}", mistake.line, mistake.column);
        text += ": " + mistake.what;
    }
    return text;
}

AssignmentMistake mistake_at(const toml::source_position& at,
                             std::string what) {
    return {static_cast<int>(at.line), static_cast<int>(at.column),
            std::move(what)};
}

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

/// Reads one parsed file; keeps what is right and notes what is wrong.
class FileReader {
public:
    explicit FileReader(const std::vector<std::string>& known)
        : known_(known) {}

    void read(const toml::table& file) {
        for (const auto& [key, value] : file) read_key(key, value);
        if (file.get("exercises") == nullptr)
            wrong({},
                  "no table [exercises] was found; expected one with a "
                  "line such as face_sides = 1 for each exercise");
        sort();
    }

    Assignment assignment;
    std::vector<AssignmentMistake> mistakes;

private:
    struct Placed {
        toml::source_position at;
        Assignment::Item item;
    };

    void wrong(const toml::source_position& at, std::string what) {
        mistakes.push_back(mistake_at(at, std::move(what)));
    }

    void read_key(const toml::key& key, const toml::node& value) {
        if (key == "name")
            read_name(value);
        else if (key == "hidden_feedback")
            read_level(value);
        else if (key == "exercises")
            read_exercises(value);
        else
            wrong(
                key.source().begin,
                fmt::format("'{}' is not a key; expected name, "
                            "hidden_feedback or [exercises]{}",
                            key.str(), course::did_you_mean(key.str(), keys)));
    }

    void read_name(const toml::node& value) {
        const auto* text = value.as_string();
        if (text != nullptr && !text->get().empty())
            assignment.name = text->get();
        else
            wrong(value.source().begin,
                  fmt::format("name is {}; expected a title in quotes",
                              found(value)));
    }

    void read_level(const toml::node& value) {
        std::vector<std::string> names;
        const auto text = value.value<std::string_view>();
        for (const LevelName& one : levels) {
            names.emplace_back(one.name);
            if (text != one.name) continue;
            assignment.hidden_feedback = one.level;
            return;
        }
        wrong(value.source().begin,
              fmt::format("hidden_feedback is {}; expected \"{}\"{}",
                          found(value), fmt::join(names, "\", \""),
                          course::did_you_mean(text.value_or(""), names)));
    }

    void read_exercises(const toml::node& value) {
        const auto* table = value.as_table();
        if (table == nullptr)
            return wrong(value.source().begin,
                         fmt::format("exercises is {}; expected a table with "
                                     "a weight for each exercise",
                                     found(value)));
        if (table->empty())
            wrong(value.source().begin,
                  "[exercises] is empty; expected at least one exercise");
        for (const auto& [key, weight] : *table) read_exercise(key, weight);
    }

    void read_exercise(const toml::key& key, const toml::node& weight) {
        const auto exercise = known_exercise(key.str());
        if (!exercise)
            wrong(key.source().begin,
                  fmt::format("'{}' is not an exercise; expected one of the "
                              "{} there are{}",
                              key.str(), known_.size(), suggestion(key.str())));
        const auto number = weight_of(weight);
        if (exercise && number)
            placed_.push_back({key.source().begin, {*exercise, *number}});
    }

    std::optional<std::string> known_exercise(std::string_view name) const {
        for (const std::string& exercise : known_)
            if (exercise == name || short_name(exercise) == name)
                return exercise;
        return std::nullopt;
    }

    std::string suggestion(std::string_view name) const {
        std::vector<std::string> names = known_;
        if (chapter(name).empty())
            for (std::string& one : names) one = short_name(one);
        return course::did_you_mean(name, names);
    }

    std::optional<double> weight_of(const toml::node& node) {
        const auto weight = node.value<double>();
        if (weight && *weight > 0 && *weight <= largest_weight) return weight;
        wrong(node.source().begin,
              fmt::format("the weight is {}; expected a number above 0 and at "
                          "most {}",
                          found(node), largest_weight));
        return std::nullopt;
    }

    /// toml++ keeps keys by alphabet; reports follow the file.
    void sort() {
        const auto by_place = [](const auto& a, const auto& b) {
            return std::pair(a.line, a.column) < std::pair(b.line, b.column);
        };
        std::sort(placed_.begin(), placed_.end(),
                  [&](const Placed& a, const Placed& b) {
                      return by_place(a.at, b.at);
                  });
        for (const Placed& one : placed_) add(one);
        std::stable_sort(mistakes.begin(), mistakes.end(), by_place);
    }

    void add(const Placed& one) {
        for (const Assignment::Item& item : assignment.exercises)
            if (item.exercise == one.item.exercise)
                return wrong(one.at,
                             fmt::format("{} is named a second time; expected "
                                         "each exercise once",
                                         item.exercise));
        assignment.exercises.push_back(one.item);
    }

    const std::vector<std::string>& known_;
    std::vector<Placed> placed_;
};

std::string contents(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(file))
        throw AssignmentError(
            file, {{0, 0, "cannot be read; expected an assignment file"}});
    if (const auto size = std::filesystem::file_size(file); size > largest_file)
        throw AssignmentError(
            file, {{0, 0,
                    fmt::format("the file has {} bytes; expected an assignment "
                                "of at most {}",
                                size, largest_file)}});
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

AssignmentError::AssignmentError(const std::filesystem::path& file,
                                 std::vector<AssignmentMistake> all)
    : std::runtime_error(all_messages(file, all)), mistakes(std::move(all)) {}

Assignment read_assignment(const std::filesystem::path& file,
                           const std::vector<std::string>& known) {
    FileReader reader(known);
    reader.assignment.name = file.stem().string();
    try {
        reader.read(toml::parse(contents(file)));
    } catch (const toml::parse_error& error) {
        // After a mistake in the notation the rest cannot be told apart.
        throw AssignmentError(file,
                              {mistake_at(error.source().begin,
                                          std::string(error.description()))});
    }
    if (!reader.mistakes.empty()) throw AssignmentError(file, reader.mistakes);
    return reader.assignment;
}

Assignment default_assignment(const std::vector<std::string>& known) {
    Assignment assignment;
    assignment.name = "All exercises";
    for (const std::string& exercise : known)
        assignment.exercises.push_back({exercise, 1});
    return assignment;
}

std::string_view short_name(std::string_view exercise) {
    return exercise.substr(exercise.rfind('/') + 1);
}

std::string_view chapter(std::string_view exercise) {
    const std::size_t slash = exercise.rfind('/');
    return slash == exercise.npos ? "" : exercise.substr(0, slash);
}

}  // namespace grader
