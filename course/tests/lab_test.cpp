// The student's program as it is built: its commands, its exit codes, and that
// no untouched skeleton passes its own check.
#include <sys/wait.h>

#include <set>

#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"

using namespace course;

namespace fs = std::filesystem;

namespace {

struct Said {
    int code = -1;
    std::string text;
};

Said lab(std::vector<std::string> arguments) {
    Command command;
    command.arguments = {build_root() / "course" / "lab"};
    command.arguments.insert(command.arguments.end(), arguments.begin(),
                             arguments.end());
    command.environment = plain_environment();
    const Finished finished =
        run(command, std::chrono::seconds(100), std::size_t{1} << 20);
    REQUIRE_FALSE(finished.timed_out);
    REQUIRE(WIFEXITED(finished.status));
    return {WEXITSTATUS(finished.status), finished.output};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

void check_usage_error(const std::vector<std::string>& arguments,
                       const std::string& words) {
    const Said said = lab(arguments);
    INFO(said.text);
    CHECK(said.code == 2);
    CHECK(contains(said.text, words));
}

}  // namespace

TEST_CASE("wrong usage ends with 2 and says what is wrong") {
    check_usage_error({}, "subcommand");
    check_usage_error({"chek"}, "subcommand");
    check_usage_error({"check"}, "exercise is required");
    check_usage_error({"check", "face_sides", "--no-such-option"},
                      "no-such-option");
    check_usage_error({"check", "face_sids"}, "did you mean face_sides?");
    check_usage_error({"check", "face_sides", "--file", "none.cpp"},
                      "none.cpp is no file");
    check_usage_error({"check", "face_sides", "--file", "/"}, "is no file");
    check_usage_error({"hint"}, "exercise is required");
    check_usage_error({"hint", "no_such_exercise"}, "no exercise");
    check_usage_error({"hint", "face_sides", "0"}, "not 0");
    check_usage_error({"hint", "face_sides", "99"}, "not 99");
    check_usage_error({"hint", "face_sides", "two"}, "two");
}

TEST_CASE("help ends with 0 and names the commands") {
    const Said said = lab({"--help"});
    CHECK(said.code == 0);
    for (const std::string command : {"check", "list", "hint"}) {
        CHECK(contains(said.text, command));
        CHECK(lab({command, "--help"}).code == 0);
    }
    CHECK(contains(lab({"check", "--help"}).text, "Exit code: 0 accepted"));
}

TEST_CASE("list names every exercise once, below its chapter") {
    const Said said = lab({"list"});
    CHECK(said.code == 0);
    std::size_t at = 0;
    std::set<std::string> chapters;
    for (const Exercise& exercise : all_exercises()) {
        if (chapters.insert(exercise.topic).second)
            at = said.text.find(exercise.topic + "\n", at);
        REQUIRE(at != std::string::npos);
        at = said.text.find("\n  " + exercise.name + " ", at);
        INFO(exercise.name);
        REQUIRE(at != std::string::npos);
    }
}

TEST_CASE("hints come one by one, at least three for each exercise") {
    for (const Exercise& exercise : all_exercises()) {
        INFO(exercise.name);
        const Said first = lab({"hint", exercise.name});
        CHECK(first.code == 0);
        CHECK(contains(first.text, "1. "));
        CHECK_FALSE(contains(first.text, "\n2. "));
        CHECK(contains(first.text, "hint " + exercise.name + " 2"));
        const Said third = lab({"hint", exercise.name, "3"});
        CHECK(third.code == 0);
        CHECK(contains(third.text, "\n3. "));
    }
}

TEST_CASE("the untouched skeleton of every exercise fails with a message") {
    const auto exercises = all_exercises();
    CHECK(exercises.size() >= 20);
    for (const Exercise& exercise : exercises) {
        const Said said = lab(
            {"check", exercise.name, "--file", exercise.skeleton().string()});
        INFO(exercise.name << "\n" << said.text);
        CHECK(said.code == 1);
        CHECK(contains(said.text, "FAILED"));
        if (contains(said.text, ": wrong answer\n"))
            CHECK(contains(said.text, "expected"));
        CHECK(contains(said.text, "got"));
        CHECK(contains(said.text, "lab hint " + exercise.name));
        CHECK(contains(said.text, "without a sandbox"));
    }
}

TEST_CASE("the reference of every exercise passes") {
    for (const Exercise& exercise : all_exercises()) {
        const fs::path file = exercise.solution();
        if (!fs::exists(file)) {
            WARN("skipped: no reference of " << exercise.name);
            continue;
        }
        const Said said =
            lab({"check", exercise.name, "--file", file.string()});
        INFO(exercise.name << "\n" << said.text);
        CHECK(said.code == 0);
        CHECK(contains(said.text, "accepted"));
        CHECK_FALSE(contains(said.text, "FAILED"));
    }
}

TEST_CASE("without --file the check is of the file in exercises") {
    const Said said = lab({"check", "face_sides"});
    CHECK(contains(said.text, "face_sides.cpp: "));
    CHECK((said.code == 0 || said.code == 1));
}
