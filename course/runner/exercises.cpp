#include "course/runner/exercises.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <tuple>

#include "course/runner/descriptors.h"
#include "course/runner/nearest.h"

namespace course {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Exercise& exercise) {
    return source_root() / "exercises" / exercise.topic;
}

std::string readme_of(const std::string& topic) {
    const fs::path file = source_root() / "exercises" / topic / "README.md";
    return fs::exists(file) ? read_file(file) : "";
}

/// Of some exercises a copy for one assignment has no more: the course includes
/// their contracts.
bool is_contract_only(const Exercise& exercise) {
    return !fs::exists(exercise.skeleton()) &&
           !fs::exists(exercise.statement());
}

/// Exercises of one topic, in the order in which its README names them.
std::vector<Exercise> exercises_of(const fs::path& folder) {
    std::vector<Exercise> list;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".h") continue;
        Exercise exercise{folder.filename(), entry.path().stem()};
        exercise.is_data = fs::exists(folder / (exercise.name + ".csv"));
        if (is_contract_only(exercise)) continue;
        list.push_back(std::move(exercise));
    }
    const std::string readme = readme_of(folder.filename());
    const auto place = [&](const Exercise& e) {
        return std::tuple(readme.find("`" + e.name + "`"), e.name);
    };
    std::sort(list.begin(), list.end(),
              [&](const Exercise& a, const Exercise& b) {
                  return place(a) < place(b);
              });
    return list;
}

/// What stands between `open` and `close` behind each `include` of a text.
std::vector<std::string> included(std::string_view text, char open,
                                  char close) {
    std::vector<std::string> names;
    const std::string_view directive = "include";
    const char ends[] = {close, '\n', '\0'};
    for (auto at = text.find(directive); at != std::string_view::npos;
         at = text.find(directive, at)) {
        at = std::min(text.find_first_not_of(" \t", at + directive.size()),
                      text.size());
        if (at == text.size() || text[at] != open) continue;
        const auto end =
            std::min(text.find_first_of(ends, at + 1), text.size());
        names.emplace_back(text.substr(at + 1, end - at - 1));
    }
    return names;
}

/// The headers of the project that a text includes, directly or not.
std::set<std::string> project_headers(std::string_view text,
                                      const fs::path& include) {
    std::set<std::string> found;
    std::vector<std::string> todo = included(text, '"', '"');
    while (!todo.empty()) {
        const std::string header = todo.back();
        todo.pop_back();
        // What is none of ours is for the compiler to complain about.
        if (!fs::is_regular_file(include / header) ||
            !found.insert(header).second)
            continue;
        for (std::string& more :
             included(read_file(include / header), '"', '"'))
            todo.push_back(std::move(more));
    }
    return found;
}

/// Of a copy for an assignment that has limits of its own.
void set_limits(std::vector<Exercise>& exercises) {
    const fs::path file = source_root() / ".lab" / "limits";
    if (!fs::exists(file)) return;
    const auto limits = read_limits_file(read_file(file));
    for (Exercise& exercise : exercises)
        if (const auto own = limits.find(exercise.name); own != limits.end())
            exercise.limits = own->second;
}

}  // namespace

fs::path source_root() {
    return COURSE_SOURCE_DIR;
}
fs::path build_root() {
    return COURSE_BINARY_DIR;
}

std::string Exercise::file_name() const {
    return name + (is_data ? ".csv" : ".cpp");
}

fs::path Exercise::contract() const {
    return folder_of(*this) / (name + ".h");
}
fs::path Exercise::skeleton() const {
    return folder_of(*this) / file_name();
}
fs::path Exercise::statement() const {
    return folder_of(*this) / (name + ".md");
}
fs::path Exercise::solution() const {
    return source_root() / "solutions" / topic / file_name();
}

std::vector<Exercise> all_exercises() {
    std::vector<fs::path> topics;
    for (const auto& entry :
         fs::directory_iterator(source_root() / "exercises"))
        if (entry.is_directory()) topics.push_back(entry.path());
    std::sort(topics.begin(), topics.end());
    std::vector<Exercise> all;
    for (const fs::path& topic : topics)
        for (Exercise& exercise : exercises_of(topic))
            all.push_back(std::move(exercise));
    set_limits(all);
    return all;
}

Exercise exercise_named(const std::string& name) {
    std::vector<std::string> names;
    for (Exercise& exercise : all_exercises()) {
        if (exercise.name == name) return exercise;
        names.push_back(exercise.name);
    }
    throw UnknownExercise(fmt::format("there is no exercise \"{}\"{}", name,
                                      did_you_mean(name, names)));
}

bool has_solutions() {
    return fs::is_directory(source_root() / "solutions");
}

std::vector<Exercise> exercises_before(const Exercise& exercise) {
    std::vector<Exercise> before;
    const auto headers =
        project_headers(read_file(exercise.contract()), source_root());
    for (const std::string& header : headers)
        if (const fs::path path = header; *path.begin() == "exercises")
            before.push_back({path.parent_path().filename(), path.stem()});
    return before;
}

std::set<std::string, std::less<>> standard_headers(std::string_view text,
                                                    const fs::path& include) {
    std::set<std::string, std::less<>> headers;
    const auto add = [&](std::string_view some) {
        for (std::string& header : included(some, '<', '>'))
            headers.insert(std::move(header));
    };
    add(text);
    for (const std::string& header : project_headers(text, include))
        add(read_file(include / header));
    return headers;
}

std::string read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw_errno("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in),
            std::istreambuf_iterator<char>()};
}

}  // namespace course
