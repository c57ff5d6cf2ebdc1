// The student's copy: nothing of the solutions and of the grader is in it, and
// it builds and works on its own.
#include <fmt/format.h>
#include <sys/wait.h>

#include <fstream>
#include <set>
#include <sstream>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

namespace fs = std::filesystem;

namespace {

course::Finished run(const std::vector<std::string>& arguments,
                     std::chrono::seconds most) {
    course::Command command;
    command.arguments = arguments;
    command.environment = course::plain_environment();
    return course::run(command, most, std::size_t{1} << 20);
}

course::Finished release(const fs::path& to) {
    return run({course::build_root() / "grader" / "grader", "release", to},
               std::chrono::seconds(100));
}

int code(const course::Finished& finished) {
    return !finished.timed_out && WIFEXITED(finished.status)
               ? WEXITSTATUS(finished.status)
               : -1;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A student's copy, made once for all tests.
const fs::path& copy() {
    static const course::TemporaryFolder folder;
    static const fs::path made = [] {
        const course::Finished finished = release(folder / "copy");
        INFO(finished.output);
        REQUIRE(code(finished) == 0);
        return folder / "copy";
    }();
    return made;
}

/// The files below a folder, relative to it.
std::set<std::string> files_below(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory())
            files.insert(fs::relative(entry.path(), folder).string());
    return files;
}

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) return "";
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

std::set<std::string> lines_of(const fs::path& file) {
    std::set<std::string> lines;
    std::istringstream in(course::read_file(file));
    for (std::string line; std::getline(in, line);) lines.insert(trimmed(line));
    return lines;
}

/// The lines, and those that begin the definition of what they declare.
std::set<std::string> with_heads(std::set<std::string> lines) {
    for (const std::string& line : std::set<std::string>(lines))
        if (!line.empty() && line.back() == ';')
            lines.insert(line.substr(0, line.size() - 1) + " {");
    return lines;
}

/// Whether anyone writes this line who has such data: it gives nothing away.
bool is_idiom(const std::string& line) {
    static const std::set<std::string> idioms = {
        "std::vector<int> corners(face.begin(), face.end());",
        "std::min_element(corners.begin(), corners.end()),",
        "std::rotate(face.begin(), std::min_element(face.begin(), "
        "face.end()),",
        "const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];",
        "std::istringstream left(line.substr(0, line.find('#')));",
    };
    return line.rfind("for (", 0) == 0 || idioms.contains(line);
}

/// Lines of references too long to be there by accident, without those that
/// the student is given in the contract or the skeleton.
std::set<std::string> secret_lines() {
    constexpr std::size_t by_accident = 40;
    std::set<std::string> secret;
    for (const course::Exercise& exercise : course::all_exercises()) {
        const auto given = with_heads(lines_of(exercise.contract()));
        const auto skeleton = lines_of(exercise.skeleton());
        for (const std::string& line : lines_of(exercise.solution()))
            if (line.size() > by_accident && !is_idiom(line) &&
                !given.count(line) && !skeleton.count(line))
                secret.insert(line);
    }
    return secret;
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

}  // namespace

TEST_CASE("the top level is the student's part of the tree") {
    std::set<std::string> names = names_in(copy());
    for (const char* hidden : {".clang-format", ".gitignore", ".clangd",
                               ".vscode", ".devcontainer", ".lab"})
        names.erase(hidden);
    CHECK(names == std::set<std::string>{"CMakeLists.txt", "README.md",
                                         "course", "data", "exercises"});
}

TEST_CASE("the copy has every exercise with all its files") {
    for (const auto& entry :
         fs::recursive_directory_iterator(course::source_root() / "exercises"))
        if (entry.is_regular_file()) {
            const auto name = fs::relative(entry.path(), course::source_root());
            INFO(name.string());
            REQUIRE(fs::exists(copy() / name));
            CHECK(course::read_file(copy() / name) ==
                  course::read_file(entry.path()));
        }
}

TEST_CASE("the copy keeps an original of each file that a student edits") {
    for (const course::Exercise& exercise : course::all_exercises()) {
        INFO(exercise.name);
        CHECK(course::read_file(copy() / ".lab" / "originals" / exercise.topic /
                                exercise.file_name()) ==
              course::read_file(exercise.skeleton()));
    }
}

TEST_CASE("no file of solutions, grader or the sample class is in the copy") {
    const auto files = files_below(copy());
    CHECK(files.size() > 100);
    std::set<std::string> withheld;
    for (const char* folder : {"solutions", "grader"})
        for (const auto& file : files_below(course::source_root() / folder))
            withheld.insert(
                course::read_file(course::source_root() / folder / file));
    withheld.erase("");
    for (const std::string& file : files) {
        INFO(file);
        CHECK_FALSE(contains(file, "solutions"));
        CHECK_FALSE(contains(file, "grader"));
        CHECK_FALSE(contains(file, "sample_class"));
        CHECK_FALSE(contains(file, ".build"));
        CHECK_FALSE(contains(file, ".git/"));
        CHECK(withheld.count(course::read_file(copy() / file)) == 0);
    }
}

TEST_CASE("no line of a reference that gives something away is in the copy") {
    const std::set<std::string> secret = secret_lines();
    CHECK(secret.size() >= 20);
    for (const std::string& file : files_below(copy())) {
        const std::string text = course::read_file(copy() / file);
        for (const std::string& line : secret) {
            // The course checks its own tables: what the exercise validate asks
            // for cannot be kept from who looks for it there.
            if (file == "course/halfedge/validate.cpp") continue;
            INFO(file << ": " << line);
            if (contains(text, line)) FAIL_CHECK("a line of a reference");
        }
    }
}

TEST_CASE("the README of the copy speaks to students only") {
    const std::string text = course::read_file(copy() / "README.md");
    CHECK(contains(text, "## For students"));
    CHECK(contains(text, "./course/lab"));
    for (const char* other : {"For instructors", "./grader/", "solutions/"}) {
        INFO(other);
        CHECK_FALSE(contains(text, other));
    }
}

TEST_CASE("scripts of the copy may be run") {
    const auto rights = fs::status(copy() / "course" / "lab").permissions();
    CHECK((rights & fs::perms::owner_exec) != fs::perms::none);
}

TEST_CASE("a folder that is not empty is refused and left as it is") {
    const course::TemporaryFolder folder;
    fs::create_directory(folder / "mine");
    std::ofstream(folder / "mine" / "thesis.txt") << "all of it";
    const course::Finished finished = release(folder / "mine");
    CHECK(code(finished) == 2);
    CHECK(contains(finished.output, "is not empty"));
    CHECK(names_in(folder / "mine") == std::set<std::string>{"thesis.txt"});
    CHECK(names_in(folder.path()) == std::set<std::string>{"mine"});
}

TEST_CASE("a file in the place of the copy is refused and left as it is") {
    const course::TemporaryFolder folder;
    std::ofstream(folder / "file") << "mine";
    CHECK(code(release(folder / "file")) == 2);
    CHECK(course::read_file(folder / "file") == "mine");
}

TEST_CASE("a folder beside the copy is left as it is") {
    const course::TemporaryFolder folder;
    fs::create_directory(folder / "copy.making");
    std::ofstream(folder / "copy.making" / "thesis.txt") << "all of it";
    CHECK(code(release(folder / "copy")) == 2);
    CHECK(fs::exists(folder / "copy.making" / "thesis.txt"));
}

TEST_CASE("an empty folder is taken, with a slash at its end, too") {
    const course::TemporaryFolder folder;
    fs::create_directory(folder / "empty");
    const course::Finished finished =
        release((folder / "empty").string() + "/");
    INFO(finished.output);
    CHECK(code(finished) == 0);
    CHECK(names_in(folder / "empty").count("exercises") == 1);
    CHECK(names_in(folder.path()) == std::set<std::string>{"empty"});
}

TEST_CASE("the copy builds and checks on its own", "[slow]") {
    const fs::path build = copy() / ".build";
    const course::Finished configured =
        run({"cmake", "-S", copy(), "-B", build, "-DCOURSE_TESTS=OFF"},
            std::chrono::minutes(10));
    INFO(configured.output);
    REQUIRE(code(configured) == 0);
    const course::Finished built = run(
        {"cmake", "--build", build, "--target", "lab_ready", "--parallel", "2"},
        std::chrono::minutes(40));
    INFO(built.output);
    REQUIRE(code(built) == 0);
    const std::string lab = build / "course" / "lab";
    const course::Finished failed =
        run({lab, "check", "face_sides"}, std::chrono::minutes(2));
    INFO(failed.output);
    CHECK(code(failed) == 1);
    CHECK(contains(failed.output, "FAILED"));
    CHECK(contains(failed.output, "lab hint face_sides"));
    const course::Finished passed = run({lab, "check", "face_sides", "--file",
                                         course::source_root() / "solutions" /
                                             "01_traversal" / "face_sides.cpp"},
                                        std::chrono::minutes(2));
    INFO(passed.output);
    CHECK(code(passed) == 0);
    CHECK(code(run({lab, "list"}, std::chrono::minutes(1))) == 0);
}
