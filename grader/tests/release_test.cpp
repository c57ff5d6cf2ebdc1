// The student's copy: nothing of the solutions and of the grader is in it, and
// it builds and works on its own.
#include "grader/pipeline/leaks.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <fstream>
#include <regex>
#include <set>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"
#include "grader/pipeline/document_links.h"

using grader::Leak;

namespace fs = std::filesystem;

namespace {

course::Finished run(const std::vector<std::string>& arguments,
                     std::chrono::seconds most) {
    course::Command command;
    command.arguments = arguments;
    command.environment = course::plain_environment();
    return course::run(command, most, std::size_t{1} << 20);
}

course::Finished release(const fs::path& to,
                         const std::vector<std::string>& more = {"--quick"},
                         std::chrono::minutes most = std::chrono::minutes(5)) {
    std::vector<std::string> arguments = {
        course::build_root() / "grader" / "grader", "release", to};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, most);
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

/// A few files that stand for a copy.
struct SmallCopy {
    SmallCopy& file(const std::string& name, const std::string& text) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
        return *this;
    }
    std::vector<Leak> leaks() const { return grader::leaks_in(folder.path()); }

    course::TemporaryFolder folder;
};

std::string suite_of_face_sides() {
    return course::read_file(course::source_root() / "grader" / "suites" /
                             "01_traversal" / "face_sides_test.cpp");
}

fs::path assignment(const course::TemporaryFolder& folder,
                    const std::string& exercises) {
    fs::path file = folder / "assignment.toml";
    std::ofstream(file) << "name = \"One\"\n[exercises]\n" << exercises;
    return file;
}

/// The targets of the links of all documents below, each with its document,
/// where there is no such file.
void check_links(const fs::path& folder) {
    const std::regex link(R"(\]\(([^()\s]+)\))");
    int count = 0;
    for (const std::string& name : files_below(folder)) {
        if (!name.ends_with(".md")) continue;
        const std::string text = course::read_file(folder / name);
        for (std::sregex_iterator at(text.begin(), text.end(), link), end;
             at != end; ++at) {
            const std::string target = (*at)[1].str();
            if (target.starts_with("http") || target.starts_with('#')) continue;
            INFO(name << ": " << target);
            ++count;
            CHECK(fs::exists((folder / name).parent_path() /
                             target.substr(0, target.find('#'))));
        }
    }
    CHECK(count > 100);
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

TEST_CASE("the sample class is not in the copy, and nothing that was built") {
    const auto files = files_below(copy());
    CHECK(files.size() > 100);
    for (const std::string& file : files) {
        INFO(file);
        CHECK_FALSE(contains(file, "solutions"));
        CHECK_FALSE(contains(file, "grader"));
        CHECK_FALSE(contains(file, "sample_class"));
        CHECK_FALSE(contains(file, ".build"));
        CHECK_FALSE(contains(file, ".git/"));
    }
}

TEST_CASE("every link of the copy leads to something") {
    check_links(copy());
}

TEST_CASE("of a link to what is missing the text stays, of a row nothing") {
    const auto mended = [](const std::string& document) {
        return grader::without_links(document, [](std::string_view target) {
            return target == "gone.md";
        });
    };
    CHECK(mended("see [`he[i]` and\nmore](gone.md#here), [it](is.md)") ==
          "see `he[i]` and\nmore, [it](is.md)");
    CHECK(mended("| a |\n|---|\n| [1](gone.md) | x |\n| [2](is.md) | "
                 "[3](gone.md) |\n| [4](gone.md) |") ==
          "| a |\n|---|\n| [2](is.md) | 3 |\n");
    CHECK(mended("One:\n\n| a |\n|---|\n| [1](gone.md) |\n| [2](gone.md) "
                 "|\n\nTwo") == "One:\n\n\nTwo");
    CHECK(mended("| a |\n|---|\n| [1](gone.md) |") == "");
    CHECK(mended("| [1](gone.md) |") == "");
    CHECK(mended("\n|---|\n| [1](gone.md) |") == "\n|---|\n");
    for (const char* same :
         {"", "](gone.md)", "[a](gone.md", "[&](int i) { he[i](gone.md, 2); }",
          "[a](#gone.md)", "[a] (gone.md)"})
        CHECK(mended(same) == same);
}

TEST_CASE("nothing hidden is in the copy") {
    CHECK(grader::secret_lines().size() >= 20);
    for (const Leak& leak : grader::leaks_in(copy())) FAIL_CHECK(text_of(leak));
}

TEST_CASE("a line of a reference is found, wherever it stands") {
    const std::string line = *grader::secret_lines().begin();
    SmallCopy small;
    small.file("course/notes.md", "One\n\n  // " + line + " // so\n");
    const auto leaks = small.leaks();
    REQUIRE(leaks.size() == 1);
    CHECK(leaks[0].file == "course/notes.md");
    CHECK(leaks[0].line == 3);
    CHECK(contains(text_of(leaks[0]), "course/notes.md:3: "));
    CHECK(contains(text_of(leaks[0]), line));
}

TEST_CASE("the name of a hidden case is found, also broken into two lines") {
    SmallCopy small;
    small
        .file("a_test.cpp",
              "\nTEST_CASE(\"faces that come to a vertex twice, or share "
              "several edges\",\n   \"[points:1]\") {}\n")
        .file("b_test.cpp",
              "TEST_CASE(\n    \"border half-edges of every mesh \"\n"
              "    \"have no face\") {}\n")
        .file("c.html",
              "<td>\n<b>border half-edges\nof every mesh have no "
              "face</b>")
        .file("d.md",
              "A phrase: border half-edges of every mesh have no face, "
              "as others.");
    std::set<std::string> found;
    for (const Leak& leak : small.leaks())
        found.insert(leak.file + ":" + std::to_string(leak.line));
    CHECK(found ==
          std::set<std::string>{"a_test.cpp:2", "b_test.cpp:2", "c.html:2"});
}

TEST_CASE("a file of the instructor is found by its bytes and by its place") {
    SmallCopy small;
    small.file("exercises/01_traversal/more_test.cpp", suite_of_face_sides())
        .file("old/grader/notes.txt", "nothing of interest");
    std::set<std::string> found;
    for (const Leak& leak : small.leaks())
        if (leak.line == 0) found.insert(text_of(leak));
    CHECK(found == std::set<std::string>{
                       "exercises/01_traversal/more_test.cpp: the same as "
                       "grader/suites/01_traversal/face_sides_test.cpp",
                       "old/grader/notes.txt: a file of grader/"});
}

TEST_CASE("names of cases are read as Catch2 knows them") {
    CHECK(grader::case_names("TEST_CASE(\"a \\\"b\\\"\", \"[points:2]\") {}\n"
                             "TEST_CASE(\n  \"c \"\n  \"d\") {}") ==
          std::vector<std::string>{"a \"b\"", "c d"});
}

TEST_CASE("the copy for an assignment has its exercises and those they need") {
    const course::TemporaryFolder folder;
    const fs::path made = folder / "copy";
    const course::Finished finished =
        release(made, {"--quick", "--assignment",
                       assignment(folder, "simplify = 1\nface_sides = 1\n")});
    INFO(finished.output);
    REQUIRE(code(finished) == 0);
    CHECK(contains(finished.output, "4 exercises"));
    std::set<std::string> statements;
    for (const std::string& file : files_below(made / "exercises"))
        if (file.ends_with(".md") && !file.ends_with("README.md"))
            statements.insert(file);
    CHECK(statements == std::set<std::string>{"01_traversal/face_sides.md",
                                              "09_processing/can_collapse.md",
                                              "09_processing/collapse.md",
                                              "09_processing/simplify.md"});
    CHECK(files_below(made / ".lab" / "originals").size() == 4);
    CHECK(names_in(made / "exercises").size() >= 2);
    const std::string page =
        course::read_file(made / "exercises" / "01_traversal" / "README.md");
    CHECK(contains(page, "](face_sides.md)"));
    CHECK_FALSE(contains(page, "face_vertices"));
    CHECK(contains(
        course::read_file(made / "exercises" / "09_processing" / "README.md"),
        "| | clustering (9.10) | local operations "
        "([9.1](can_collapse.md) to 9.7) |"));
    check_links(made);
    CHECK_FALSE(fs::exists(made / "course" / "tests" / "lab_test.cpp"));
}

TEST_CASE("the copy has the limits of its assignment, and lab reads them") {
    const course::TemporaryFolder folder;
    const std::string file = assignment(
        folder, "tip = 1\nprev = 1\n[limits.prev]\nmemory_mib = 64\n");
    REQUIRE(code(release(folder / "copy", {"--quick", "--assignment", file})) ==
            0);
    const auto limits = course::read_limits_file(
        course::read_file(folder / "copy" / ".lab" / "limits"));
    REQUIRE(limits.size() == 1);
    CHECK(limits.at("prev").memory_mib == 64);
    CHECK_FALSE(fs::exists(copy() / ".lab" / "limits"));
}

TEST_CASE("a mistake in the assignment is named, and nothing is made") {
    const course::TemporaryFolder folder;
    const course::Finished finished = release(
        folder / "copy",
        {"--quick", "--assignment", assignment(folder, "face_size = 1\n")});
    CHECK(code(finished) == 2);
    CHECK(contains(finished.output, "face_sides"));
    CHECK(names_in(folder.path()) == std::set<std::string>{"assignment.toml"});
}

TEST_CASE("the archive holds the copy, and equal copies give equal archives") {
    const course::TemporaryFolder folder;
    const std::string file = assignment(folder, "face_sides = 1\n");
    for (const char* name : {"one", "two"}) {
        const fs::path made = folder / name;
        REQUIRE(code(release(made / "copy",
                             {"--quick", "--assignment", file, "--zip",
                              made.string() + ".zip"})) == 0);
    }
    CHECK(course::read_file(folder / "one.zip") ==
          course::read_file(folder / "two.zip"));
    fs::create_directory(folder / "out");
    REQUIRE(code(run({"cmake", "-E", "chdir", folder / "out", "cmake", "-E",
                      "tar", "xf", folder / "one.zip"},
                     std::chrono::seconds(60))) == 0);
    const fs::path copy = folder / "one" / "copy",
                   got = folder / "out" / "copy";
    CHECK(files_below(got) == files_below(copy));
    for (const std::string& name : files_below(copy)) {
        INFO(name);
        CHECK(course::read_file(got / name) == course::read_file(copy / name));
        CHECK(fs::status(got / name).permissions() ==
              fs::status(copy / name).permissions());
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

TEST_CASE("the copy builds and checks on its own", "[.slow]") {
    const course::TemporaryFolder folder;
    const fs::path made = folder / "copy";
    const auto before = std::set<std::string>{"assignment.toml", "copy"};
    const course::Finished finished = release(
        made,
        {"--assignment", assignment(folder, "complete_table = 1\neuler = 1\n")},
        std::chrono::minutes(40));
    INFO(finished.output);
    REQUIRE(code(finished) == 0);
    // One that builds on others, too: there are no references to link.
    CHECK(contains(finished.output, "4 exercises"));
    CHECK(contains(finished.output, "built and tried"));
    CHECK(names_in(folder.path()) == before);
    CHECK_FALSE(fs::exists(made / ".build"));
    CHECK_FALSE(fs::exists(made / ".lab" / "progress"));
}
