#include "course/cli/progress.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <array>
#include <vector>

#include "course/cli/commands.h"
#include "course/mesh/file_defects.h"
#include "course/runner/descriptors.h"

namespace course {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view heading =
    "# What ./course/lab remembers: the current exercise, and a line for each\n"
    "# that was checked: tried, solved, or broken (solved once, not now); and\n"
    "# a mark of the text that was checked.\n";

/// The names of states in the file, by their numbers.
constexpr std::array<std::string_view, 4> state_names = {"untouched", "tried",
                                                         "solved", "broken"};

fs::path progress_file(const Desk& desk) {
    return desk.memory() / "progress";
}

std::string text_of(const Progress& progress) {
    std::string text(heading);
    if (!progress.current.empty())
        text += fmt::format("current {}\n", progress.current);
    for (const auto& [name, entry] : progress.entries)
        text += fmt::format(
            "{} {} {}\n", state_names.at(static_cast<std::size_t>(entry.state)),
            name, entry.mark);
    return text;
}

/// Takes one line over; false when it is none of ours.
bool take_line(std::string_view line, Progress& progress) {
    std::vector<std::string_view> parts;
    split(line, parts);
    if (parts.size() == 2 && parts[0] == "current") {
        progress.current = parts[1];
        return true;
    }
    const auto found =
        std::find(state_names.begin(), state_names.end(), parts[0]);
    if (found == state_names.end() || parts.size() != 3) return false;
    progress.entries[std::string(parts[1])] = {
        static_cast<State>(found - state_names.begin()), std::string(parts[2])};
    return true;
}

}  // namespace

std::string_view words(State state) {
    constexpr std::array<std::string_view, 4> all = {"", "tried", "solved",
                                                     "BROKEN"};
    return all.at(static_cast<std::size_t>(state));
}

State Progress::state(const Exercise& exercise) const {
    const auto found = entries.find(exercise.name);
    return found == entries.end() ? State::untouched : found->second.state;
}

void Progress::note(const Exercise& exercise, std::string_view text,
                    bool accepted) {
    const State before = state(exercise);
    const bool was_solved = before == State::solved || before == State::broken;
    entries[exercise.name] = {accepted     ? State::solved
                              : was_solved ? State::broken
                                           : State::tried,
                              mark_of(text)};
}

Exercise Progress::current_exercise() const {
    const std::vector<Exercise> all = all_exercises();
    for (const Exercise& exercise : all)
        if (exercise.name == current) return exercise;
    return state(all.at(0)) == State::solved ? next_after(all[0]) : all[0];
}

Exercise Progress::next_after(const Exercise& exercise) const {
    std::vector<Exercise> all = all_exercises();
    const auto here = std::find_if(
        all.begin(), all.end(),
        [&](const Exercise& other) { return other.name == exercise.name; });
    if (here != all.end()) std::rotate(all.begin(), here + 1, all.end());
    for (const Exercise& other : all)
        if (state(other) != State::solved) return other;
    return exercise;
}

std::string mark_of(std::string_view text) {
    // FNV-1a.
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

Progress read_progress(const Desk& desk) {
    const fs::path file = progress_file(desk);
    Progress progress;
    if (!fs::exists(file)) return progress;
    const std::string text = read_file(file);
    Lines lines{std::string_view(text)};
    while (lines.next())
        if (!lines.line().empty() && !take_line(lines.line(), progress))
            throw CannotBegin(fmt::format(
                "{}:{}: \"{}\" is no line of lab's: expected a state, an "
                "exercise and a mark. Remove the line.",
                file.string(), lines.number(), lines.line()));
    return progress;
}

void change_progress(const Desk& desk,
                     const std::function<void(Progress&)>& change) {
    fs::create_directories(desk.memory());
    const Descriptor lock(
        ::open(desk.memory().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock) ::flock(lock.get(), LOCK_EX);
    Progress progress = read_progress(desk);
    const std::string before = text_of(progress);
    change(progress);
    if (const std::string text = text_of(progress); text != before)
        replace_text(progress_file(desk), text);
}

std::optional<fs::path> reset_exercise(const Desk& desk,
                                       const Exercise& exercise) {
    auto kept = desk.reset(exercise);
    change_progress(desk, [&](Progress& progress) {
        progress.entries.erase(exercise.name);
    });
    return kept;
}

Exercise exercise_or_current(const Desk& desk, const std::string& name) {
    return name.empty() ? read_progress(desk).current_exercise()
                        : exercise_named(name);
}

}  // namespace course
