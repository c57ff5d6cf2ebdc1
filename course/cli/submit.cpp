// lab submit [WHAT...]: the archive to be handed in.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "course/cli/check.h"
#include "course/cli/commands.h"
#include "course/cli/zip.h"
#include "course/mesh/file_defects.h"

namespace course {

namespace {

namespace fs = std::filesystem;

/// The exercises that are meant: by name, by chapter; where nothing is said,
/// those of all chapters in which something is begun.
std::vector<Exercise> wanted(const Desk& desk,
                             const std::vector<std::string>& words) {
    const std::vector<Exercise> all = all_exercises();
    std::set<std::string> names(words.begin(), words.end());
    if (words.empty())
        for (const Exercise& exercise : begun(desk, all))
            names.insert(exercise.topic);
    std::vector<Exercise> list;
    std::set<std::string> used;
    for (const Exercise& exercise : all)
        for (const std::string& name : {exercise.topic, exercise.name})
            if (names.contains(name) && used.insert(exercise.name).second)
                list.push_back(exercise);
    for (const std::string& word : words)
        if (std::none_of(all.begin(), all.end(), [&](const Exercise& e) {
                return e.topic == word || e.name == word;
            }))
            exercise_named(word);  // says what is like it
    return list;
}

std::string missing_of(const std::vector<Exercise>& asked,
                       const std::vector<Exercise>& have) {
    std::string text;
    for (const Exercise& exercise : asked)
        if (std::none_of(have.begin(), have.end(), [&](const Exercise& e) {
                return e.name == exercise.name;
            }))
            text += fmt::format("  {}\n", exercise.full_name());
    return text;
}

int submit(const Desk& desk, const std::vector<std::string>& words,
           const fs::path& out) {
    const std::vector<Exercise> asked = wanted(desk, words);
    const std::vector<Exercise> have = begun(desk, asked);
    if (have.empty())
        throw CannotBegin("nothing of that is begun: no file to hand in");
    const auto results = check_many(desk, have, [](std::size_t) {});
    std::map<std::string, std::string> files;
    for (const Exercise& exercise : have)
        files[exercise.file_name()] = read_file(desk.file(exercise));
    replace_text(out, zip_of(files));
    fmt::print("{}{} not begun.\n", table_of(have, results),
               asked.size() - have.size());
    const std::string missing = missing_of(asked, have);
    if (!missing.empty()) fmt::print("\nNot in the archive:\n{}", missing);
    fmt::print("\n{} has {}. Hand it in as it is.\n", out.string(),
               counted(files.size(), "file"));
    return missing.empty() ? exit_code(results)
                           : std::max(1, exit_code(results));
}

}  // namespace

void add_submit(CLI::App& program, const Desk& desk, int& code) {
    struct Options {
        std::vector<std::string> words;
        fs::path out = "submission.zip";
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "submit", "Check your files and pack them to be handed in");
    command->add_option("what", options->words,
                        "chapters and exercises (default: the chapters that "
                        "you have begun)");
    command->add_option("--out", options->out,
                        "the archive (default: submission.zip)");
    command->footer(
        "Exit code: 0 all is there and accepted, 1 something is missing or not "
        "accepted; the archive is made in both cases.");
    command->callback([options, &desk, &code] {
        code = submit(desk, options->words, options->out);
    });
}

}  // namespace course
