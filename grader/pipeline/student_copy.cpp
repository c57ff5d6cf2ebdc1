#include "grader/pipeline/student_copy.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <map>
#include <set>

#include "course/mesh/file_defects.h"
#include "course/runner/pool.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"
#include "grader/pipeline/document_links.h"

namespace grader {

namespace {

namespace fs = std::filesystem;
using course::Exercise;

/// What of the top level a student gets; everything else stays here.
constexpr const char* released[] = {
    "CMakeLists.txt", "course",  "exercises", "data",         ".clang-format",
    ".gitignore",     ".clangd", ".vscode",   ".devcontainer"};

bool is_among(const Exercise& exercise, const std::vector<Exercise>& list) {
    return std::any_of(list.begin(), list.end(), [&](const Exercise& other) {
        return other.name == exercise.name;
    });
}

std::vector<Exercise> without(const std::vector<Exercise>& some) {
    std::vector<Exercise> others = course::all_exercises();
    std::erase_if(others,
                  [&](const Exercise& one) { return is_among(one, some); });
    return others;
}

std::vector<std::string> texts_below(const fs::path& folder) {
    std::vector<std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            texts.push_back(course::read_file(entry.path()));
    return texts;
}

fs::path contract_in_tree(const Exercise& exercise) {
    return fs::path("exercises") / exercise.topic / (exercise.name + ".h");
}

/// Of these exercises, the contracts without which course/ does not compile.
std::set<fs::path> contracts_in_use(const std::vector<Exercise>& exercises) {
    std::set<fs::path> used;
    if (exercises.empty()) return used;
    const auto texts = texts_below(course::source_root() / "course" / "player");
    for (const Exercise& exercise : exercises) {
        const fs::path contract = contract_in_tree(exercise);
        const std::string include = "#include \"" + contract.string() + '"';
        if (std::none_of(texts.begin(), texts.end(), [&](const auto& text) {
                return text.find(include) != text.npos;
            }))
            continue;
        used.insert(contract);
        for (const Exercise& before : course::exercises_before(exercise))
            used.insert(contract_in_tree(before));
    }
    return used;
}

/// What of a tree goes into a copy.
class Choice {
public:
    explicit Choice(const std::vector<Exercise>& exercises)
        : missing_(without(exercises)), contracts_(contracts_in_use(missing_)) {
        for (const Exercise& exercise : exercises)
            chapters_.insert(exercise.topic);
    }

    /// `path` is a file's, relative to the tree.
    bool takes(const fs::path& path) const {
        const std::string text = path.string();
        if (text.starts_with("data/sample_class")) return false;
        if (text.starts_with("course/tests/") && !missing_.empty())
            return path.filename() == "catch2_main.cpp";
        return *path.begin() != "exercises" || takes_exercise(path);
    }

private:
    bool takes_exercise(const fs::path& path) const {
        if (contracts_.contains(path)) return true;
        const std::string chapter = path.parent_path().filename().string();
        if (path.filename() == "README.md") return chapters_.contains(chapter);
        const std::string stem = path.stem().string();
        return std::none_of(
            missing_.begin(), missing_.end(), [&](const Exercise& e) {
                return e.topic == chapter &&
                       (stem == e.name || stem == e.name + "_test");
            });
    }

    std::vector<Exercise> missing_;
    std::set<fs::path> contracts_;
    std::set<std::string> chapters_;
};

/// Folders are made when a file comes into them.
void copy_tree(const fs::path& path, const fs::path& to, const Choice& choice) {
    const fs::path from = course::source_root() / path;
    if (fs::is_directory(from)) {
        for (const auto& entry : fs::directory_iterator(from))
            copy_tree(path / entry.path().filename(), to, choice);
    } else if (choice.takes(path)) {
        fs::create_directories((to / path).parent_path());
        fs::copy_file(from, to / path);
    }
}

/// Takes links out of a document that lead to what stayed here.
void mend_links(const fs::path& copy, const fs::path& document) {
    const fs::path folder = document.parent_path();
    const fs::path before = course::source_root() / fs::relative(folder, copy);
    const std::string text = course::read_file(document);
    const std::string mended =
        without_links(text, [&](std::string_view target) {
            return fs::exists(before / target) && !fs::exists(folder / target);
        });
    if (mended != text) course::replace_text(document, mended);
}

void mend_all_links(const fs::path& copy) {
    std::vector<fs::path> documents;
    for (const auto& entry : fs::recursive_directory_iterator(copy))
        if (entry.path().extension() == ".md")
            documents.push_back(entry.path());
    for (const fs::path& document : documents) mend_links(copy, document);
}

/// `lab reset` puts a student's file back to what stands here.
void keep_originals(const fs::path& dir, const std::vector<Exercise>& all) {
    for (const Exercise& exercise : all) {
        const fs::path folder = dir / ".lab" / "originals" / exercise.topic;
        fs::create_directories(folder);
        fs::copy_file(exercise.skeleton(), folder / exercise.file_name());
    }
}

/// Lab finds there what grading will allow.
void write_limits(const fs::path& dir, const std::vector<Exercise>& all) {
    std::map<std::string, course::Limits> others;
    for (const Exercise& exercise : all)
        if (exercise.limits != course::Limits())
            others[exercise.name] = exercise.limits;
    if (!others.empty())
        course::replace_text(dir / ".lab" / "limits",
                             course::limits_file(others));
}

/// The student's part of the README: title, and from its heading to the next.
std::string student_readme(const std::string& readme) {
    const std::string heading = "## For students";
    const auto begin = readme.find(heading);
    if (begin == std::string::npos)
        throw course::SystemError("README.md has no section \"" + heading +
                                  "\"");
    const auto end = readme.find("\n## ", begin + heading.size());
    const std::string title = readme.substr(0, readme.find('\n'));
    return title + "\n\n" +
           readme.substr(begin, end == std::string::npos ? end : end - begin) +
           "\n";
}

/// The copy as a student has it who has just unpacked it, built.
class Trial {
public:
    explicit Trial(const fs::path& copy) {
        fs::copy(copy, root_, fs::copy_options::recursive);
    }

    void build() {
        const fs::path build = root_ / ".build";
        must({"cmake", "-S", root_, "-B", build, "-DCOURSE_TESTS=OFF"});
        must({"cmake", "--build", build, "--parallel",
              std::to_string(course::core_count()), "--target", "lab_ready"});
    }

    /// Puts a file in the place of the student's.
    void hand_in(const Exercise& exercise, const fs::path& file) {
        course::replace_text(mine(exercise), course::read_file(file));
    }

    struct Said {
        int code = -1;
        std::string text;
    };

    Said lab_checks(const std::string& what) const {
        return run({root_ / ".build" / "course" / "lab", "check", what});
    }

private:
    fs::path mine(const Exercise& exercise) const {
        return root_ / "exercises" / exercise.topic / exercise.file_name();
    }

    static Said run(const std::vector<std::string>& arguments) {
        course::Command command;
        command.arguments = arguments;
        command.environment = course::plain_environment();
        const course::Finished finished =
            course::run(command, std::chrono::hours(2), std::size_t{1} << 20);
        const bool ended = !finished.timed_out && WIFEXITED(finished.status);
        return {ended ? WEXITSTATUS(finished.status) : -1, finished.output};
    }

    static void must(const std::vector<std::string>& arguments) {
        const Said said = run(arguments);
        if (said.code != 0)
            throw course::SystemError("the student's copy does not build:\n" +
                                      said.text);
    }

    course::TemporaryFolder folder_;
    fs::path root_ = folder_ / "copy";
};

std::string complaint_about_skeleton(const Trial::Said& said,
                                     const Exercise& exercise) {
    const std::string first = said.text.substr(0, said.text.find('\n'));
    if (said.code == 1 && !first.ends_with(": compile error")) return "";
    return fmt::format(
        "{}: the skeleton must compile and not be accepted, but lab says\n{}",
        exercise.full_name(), said.text);
}

}  // namespace

std::vector<Exercise> released_exercises(
    const std::optional<Assignment>& assignment) {
    if (!assignment) return course::all_exercises();
    std::map<std::string, course::Limits> limits;  // by name
    for (const Exercise& exercise : exercises_of(assignment)) {
        limits[exercise.name] = exercise.limits;
        for (const Exercise& before : course::exercises_before(exercise))
            limits.try_emplace(before.name);
    }
    std::vector<Exercise> list = course::all_exercises();
    std::erase_if(list,
                  [&](const Exercise& e) { return !limits.contains(e.name); });
    for (Exercise& exercise : list) exercise.limits = limits[exercise.name];
    return list;
}

void make_student_copy(const fs::path& to,
                       const std::vector<Exercise>& exercises) {
    fs::create_directories(to);
    const Choice choice(exercises);
    for (const char* name : released)
        if (fs::exists(course::source_root() / name))
            copy_tree(name, to, choice);
    keep_originals(to, exercises);
    write_limits(to, exercises);
    course::replace_text(
        to / "README.md",
        student_readme(course::read_file(course::source_root() / "README.md")));
    mend_all_links(to);
}

std::vector<std::string> complaints_about_copy(
    const fs::path& copy, const std::vector<Exercise>& exercises,
    const std::function<void(const std::string&)>& say) {
    Trial trial(copy);
    say("building the copy");
    trial.build();
    say("trying the references");
    for (const Exercise& exercise : exercises)
        trial.hand_in(exercise, exercise.solution());
    std::vector<std::string> complaints;
    if (const Trial::Said said = trial.lab_checks("all"); said.code != 0)
        complaints.push_back(
            "the references must all be accepted, but lab says\n" + said.text);
    say("trying the skeletons");
    for (const Exercise& exercise : exercises)
        trial.hand_in(exercise, exercise.skeleton());
    for (const Exercise& exercise : exercises)
        if (std::string complaint = complaint_about_skeleton(
                trial.lab_checks(exercise.name), exercise);
            !complaint.empty())
            complaints.push_back(std::move(complaint));
    return complaints;
}

}  // namespace grader
