// grader plagiarism SUBMISSIONS --assignment FILE --out DIR
#include <fmt/format.h>

#include <algorithm>

#include "course/mesh/file_defects.h"
#include "course/report/escape.h"
#include "grader/cli/class_session.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/similarity_export.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

struct PlagiarismOptions {
    ClassOptions of_class;
    bool anonymous = false;
};

/// As an argument for a shell.
std::string quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

/// Dolos refuses to look at fewer than two files.
bool can_be_compared(const SubmittedClass& submitted, std::size_t exercise) {
    return std::count_if(submitted.submissions.begin(),
                         submitted.submissions.end(),
                         [&](const Submission& one) {
                             return one.files[exercise].has_value();
                         }) >= 2;
}

void print_commands(const fs::path& out, const SubmittedClass& submitted,
                    const std::vector<course::Exercise>& exercises) {
    fmt::print(
        "JPlag, all exercises at once:\n  cd {} && java -jar jplag.jar -l cpp "
        "-bc base submissions\nDolos, an exercise at a time:\n",
        quoted(out.string()));
    for (std::size_t k = 0; k < exercises.size(); ++k)
        if (!exercises[k].is_data && can_be_compared(submitted, k))
            fmt::print(
                "  cd {} && dolos run -f web -l cpp -i base/{} "
                "info_{}.csv\n",
                quoted(out.string()), exercises[k].file_name(),
                exercises[k].name);
}

int plagiarism_command(const PlagiarismOptions& options) {
    const fs::path& out = options.of_class.out;
    const fs::path names_file = out.string() + ".names.csv";
    if (fs::exists(out) && !fs::is_empty(out))
        throw CannotBegin(fmt::format("{} is not empty; expected a new folder",
                                      out.string()));
    const auto exercises =
        exercises_of(assignment_in(options.of_class.assignment));
    const SubmittedClass submitted =
        submissions_of(options.of_class, exercises);
    const auto names = export_for_similarity(
        submitted, exercises,
        options.anonymous ? Naming::anonymous : Naming::ids, out);
    for (const std::string& note : submitted.notes)
        fmt::print("note: {}\n", course::escape_terminal(note));
    fmt::print("{} submissions are in {}.\n", names.size(), out.string());
    if (options.anonymous) {
        course::replace_text(names_file, names_csv(submitted, names));
        fmt::print("Who is who stands in {}, and stays with you.\n",
                   names_file.string());
    }
    print_commands(out, submitted, exercises);
    return 0;
}

}  // namespace

void add_plagiarism(CLI::App& program, int& code) {
    auto options = std::make_shared<PlagiarismOptions>();
    CLI::App* command = program.add_subcommand(
        "plagiarism",
        "Lay a class out for JPlag and Dolos, which look for "
        "copied code");
    command
        ->add_option("dir", options->of_class.dir,
                     "the folder of the class, or an archive of it")
        ->required();
    command
        ->add_option("--assignment", options->of_class.assignment,
                     "which exercises")
        ->required();
    command->add_option("--out", options->of_class.out, "a new folder")
        ->required();
    command->add_flag("--anonymous", options->anonymous,
                      "student_001 in place of names; what stands in the files "
                      "themselves stays");
    command->footer(
        "The skeletons are the base code, which does not count as copied. "
        "Prints the command\nlines of both programs, which are not part of "
        "this one.\nExit code: 0 done, 2 wrong usage.");
    command->callback(
        [options, &code] { code = plagiarism_command(*options); });
}

}  // namespace grader
