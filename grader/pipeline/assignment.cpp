#include "grader/pipeline/assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

#include "grader/pipeline/assignment_reader.h"

namespace grader {

namespace {

// A few hundred exercises. toml++ 3.3 limits the depth of lists, but not of
// dotted keys: it ends on a full stack at 32 000 of them in a row.
constexpr std::uintmax_t largest_file = 16 << 10;

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
    AssignmentReader reader(known);
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
        assignment.exercises.push_back({exercise, 1, false});
    return assignment;
}

std::vector<course::Exercise> exercises_of(
    const std::optional<Assignment>& assignment) {
    if (!assignment) return course::all_exercises();
    std::vector<course::Exercise> exercises;
    for (const Assignment::Item& item : assignment->exercises) {
        exercises.push_back(
            course::exercise_named(std::string(short_name(item.exercise))));
        exercises.back().limits = item.limits;
    }
    return exercises;
}

FeedbackLevel hidden_feedback_at(const Assignment& assignment, Instant now) {
    const bool is_over = !assignment.due || now > assignment.due->at;
    return is_over ? assignment.hidden_feedback.after_due
                   : assignment.hidden_feedback.before_due;
}

std::vector<SharedLimits> limits_of(const Assignment& assignment) {
    std::vector<SharedLimits> all;
    for (const Assignment::Item& item : assignment.exercises) {
        const auto same = [&](const SharedLimits& one) {
            return one.limits == item.limits;
        };
        auto shared = std::find_if(all.begin(), all.end(), same);
        if (shared == all.end())
            shared = all.insert(shared, SharedLimits{item.limits, {}, {}});
        shared->exercises.emplace_back(short_name(item.exercise));
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.exercises.size() > b.exercises.size();
    });
    for (SharedLimits& one : all)
        one.title = fmt::format("limits of {}", fmt::join(one.exercises, ", "));
    if (!all.empty()) all[0].title = "limits";
    return all;
}

std::string text_of(const course::Limits& limits) {
    constexpr double ms = 1000;
    return fmt::format(
        "{} s for a call, {} s for a case, {} s for all; {} s of CPU in which "
        "a case ends or takes more memory; {} MiB",
        limits.call_ms / ms, limits.case_ms / ms, limits.run_ms / ms,
        limits.cpu_ms / ms, limits.memory_mib);
}

std::string_view short_name(std::string_view exercise) {
    return exercise.substr(exercise.rfind('/') + 1);
}

std::string_view chapter(std::string_view exercise) {
    const std::size_t slash = exercise.rfind('/');
    return slash == exercise.npos ? "" : exercise.substr(0, slash);
}

}  // namespace grader
