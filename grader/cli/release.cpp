// grader release [DIR]
#include <fmt/format.h>

#include "course/mesh/file_defects.h"
#include "grader/cli/class_session.h"
#include "grader/cli/commands.h"
#include "grader/pipeline/gradescope_bundle.h"
#include "grader/pipeline/leaks.h"
#include "grader/pipeline/student_copy.h"
#include "grader/pipeline/zip_files.h"

namespace grader {

namespace {

namespace fs = std::filesystem;

struct ReleaseOptions {
    fs::path dir, assignment, zip, gradescope;
    bool is_quick = false;
};

/// The same place, without a slash at its end.
fs::path plain(const fs::path& given) {
    const fs::path path = fs::absolute(given).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

void require_new(const fs::path& dir, const fs::path& making) {
    if (fs::exists(dir) && !fs::is_empty(dir))
        throw CannotBegin(fmt::format(
            "{} is not empty: the student's copy wants a folder of its own",
            dir.string()));
    if (fs::exists(making))
        throw CannotBegin(fmt::format(
            "{} is in the way: remove it if a release that was cut short has "
            "left it",
            making.string()));
}

/// What the copy must not have; says how much it was compared with.
bool holds_nothing_hidden(const fs::path& copy) {
    const std::vector<Leak> leaks = leaks_in(copy);
    for (const Leak& leak : leaks) fmt::print("{}\n", text_of(leak));
    return leaks.empty();
}

bool works(const fs::path& copy,
           const std::vector<course::Exercise>& exercises) {
    const auto complaints = complaints_about_copy(
        copy, exercises,
        [](const std::string& what) { fmt::print(stderr, "{} ...\n", what); });
    for (const std::string& complaint : complaints)
        fmt::print("{}\n", complaint);
    return complaints.empty();
}

/// Made beside its place and renamed: nobody finds half a copy, or one that was
/// refused.
class Making {
public:
    explicit Making(const fs::path& dir)
        : dir_(dir), making_(dir.string() + ".making") {
        require_new(dir_, making_);
    }
    ~Making() {
        std::error_code ignored;
        if (is_ours_) fs::remove_all(making_, ignored);
    }
    Making(const Making&) = delete;
    Making& operator=(const Making&) = delete;

    const fs::path& begin() {
        is_ours_ = true;
        return making_;
    }
    void finish() {
        if (fs::exists(dir_)) fs::remove(dir_);
        fs::rename(making_, dir_);
        is_ours_ = false;
    }

private:
    fs::path dir_, making_;
    bool is_ours_ = false;
};

int refuse(const char* why) {
    fmt::print("Not released: {}.\n", why);
    return 1;
}

int release_copy(const ReleaseOptions& options,
                 const std::optional<Assignment>& assignment) {
    const fs::path dir = plain(options.dir);
    const auto exercises = released_exercises(assignment);
    Making making(dir);
    const fs::path& copy = making.begin();
    make_student_copy(copy, exercises);
    if (!holds_nothing_hidden(copy))
        return refuse("it would give away what is named above");
    if (!options.is_quick && !works(copy, exercises))
        return refuse("the copy does not work");
    making.finish();
    if (!options.zip.empty())
        course::replace_text(options.zip, zip_of_files(files_to_pack(
                                              dir, dir.filename().string())));
    fmt::print(
        "The student's copy is in {}: {}, no solutions, nothing of the "
        "grader{}.\n",
        dir.string(), course::counted(exercises.size(), "exercise"),
        options.is_quick ? "; not built, not tried" : "; built and tried");
    return 0;
}

int release_bundle(const ReleaseOptions& options) {
    course::replace_text(options.gradescope,
                         gradescope_bundle(options.assignment));
    fmt::print(
        "{} is the autograder of {}: it holds solutions and hidden suites, and "
        "is for Gradescope only.\n",
        options.gradescope.string(), options.assignment.string());
    return 0;
}

int release_command(const ReleaseOptions& options) {
    if (options.dir.empty() && options.gradescope.empty())
        throw CannotBegin("a folder for the student's copy, or --gradescope");
    if (!options.gradescope.empty() && options.assignment.empty())
        throw CannotBegin("--gradescope wants an --assignment");
    const auto assignment = assignment_in(options.assignment);
    const int code =
        options.dir.empty() ? 0 : release_copy(options, assignment);
    if (code != 0 || options.gradescope.empty()) return code;
    return release_bundle(options);
}

}  // namespace

void add_release(CLI::App& program, int& code) {
    auto options = std::make_shared<ReleaseOptions>();
    CLI::App* command = program.add_subcommand(
        "release",
        "Make the student's copy: this tree without solutions and grader, "
        "proved to hold nothing hidden, built and tried");
    CLI::Option* dir =
        command->add_option("dir", options->dir, "a new or empty folder");
    command->add_option("--assignment", options->assignment,
                        "with its exercises only, and those that they build "
                        "on (default: all)");
    command->add_option("--zip", options->zip, "an archive of the copy as well")
        ->needs(dir);
    command->add_flag("--quick", options->is_quick,
                      "do not build and try the copy, which takes minutes");
    command->add_option("--gradescope", options->gradescope,
                        "make the archive of an autograder for Gradescope");
    command->footer(
        "Exit code: 0 made, 1 refused: the copy would give something away or "
        "does not\nwork, 2 wrong usage, 3 the grader itself failed.");
    command->callback([options, &code] { code = release_command(*options); });
}

}  // namespace grader
