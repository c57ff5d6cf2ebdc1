// The student's program as it is built: its commands, its exit codes, and that
// no untouched skeleton passes its own check.
#include <sys/wait.h>

#include <fstream>
#include <set>

#include "course/cli/desk.h"
#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

using namespace course;

namespace fs = std::filesystem;

namespace {

struct Said {
    int code = -1;
    std::string text;
};

Said lab(std::vector<std::string> arguments,
         const std::vector<std::string>& environment = {}) {
    Command command;
    command.arguments = {build_root() / "course" / "lab"};
    command.arguments.insert(command.arguments.end(), arguments.begin(),
                             arguments.end());
    command.environment = plain_environment();
    command.environment.insert(command.environment.end(), environment.begin(),
                               environment.end());
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
    check_usage_error({"chek"}, "chek");
    check_usage_error({"--work", "/no/such/folder"}, "/no/such/folder");
    check_usage_error({"check", "face_sides", "--no-such-option"},
                      "no-such-option");
    check_usage_error({"check", "face_sids"}, "did you mean face_sides?");
    check_usage_error({"check", "face_sides", "--file", "none.cpp"},
                      "none.cpp is no file");
    check_usage_error({"check", "face_sides", "--file", "/"}, "is no file");
    check_usage_error({"reset"}, "exercise is required");
    check_usage_error({"submit", "face_sids"}, "did you mean face_sides?");
    check_usage_error({"hint", "no_such_exercise"}, "no exercise");
    check_usage_error({"hint", "face_sides", "0"}, "not 0");
    check_usage_error({"hint", "face_sides", "99"}, "not 99");
    check_usage_error({"hint", "face_sides", "two"}, "two");
    check_usage_error({"demo"}, "which exercise?");
    check_usage_error({"demo", "area_vector"}, "without a half-edge table");
    check_usage_error({"demo", "face_sides", "--file", "none.cpp"},
                      "none.cpp is no file");
    check_usage_error({"demo", "face_sides", "--mesh", "none.obj"},
                      "none.obj: cannot be read");
    check_usage_error({"demo", "face_sides", "--all", "pages"}, "excludes");
    check_usage_error({"demo", "face_sides", "--port", "8000"}, "requires");
}

TEST_CASE("help ends with 0 and names the commands") {
    const Said said = lab({"--help"});
    CHECK(said.code == 0);
    for (const std::string command :
         {"check", "list", "hint", "next", "status", "reset", "submit",
          "doctor", "figures", "clean"}) {
        CHECK(contains(said.text, command));
        CHECK(lab({command, "--help"}).code == 0);
    }
    CHECK(contains(lab({"check", "--help"}).text, "Exit code: 0 accepted"));
}

TEST_CASE("clean mends a mesh, says how, and refuses what is no mesh file") {
    const TemporaryFolder folder;
    const std::string bad = folder / "bad.obj";
    const std::string good = folder / "good.off";
    std::ofstream(bad) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 7 7 7\n"
                          "f 1 2 3\nf 2 3 1\nf 1 2 4\nl 1 2\n";
    const Said first = lab({"clean", bad, good});
    CHECK(first.code == 0);
    CHECK(contains(first.text,
                   "a face comes once: face 1 dropped\n"
                   "loose edge 0 joins vertices 0 and 1, but an edge of faces "
                   "0 and 2 does so already: dropped\n"
                   "face 2 turned over, to be wound as the others\n" +
                       good + ": 3 changes, 5 vertices, 2 faces\n"));
    CHECK(lab({"clean", good, good, "--fill", "4", "--drop-unused"}).text ==
          "hole of 4 edges filled by a face: vertices 2, 1, 3 and 0\n"
          "vertex 4 dropped: no face and no edge there\n" +
              good + ": 2 changes, 4 vertices, 3 faces\n");
    CHECK(contains(lab({"clean", good, good}).text, ": 0 changes, "));
    check_usage_error({"clean", bad}, "out is required");
    check_usage_error({"clean", bad, "mesh.xyz"},
                      "expected .obj, .off or .ply");
    check_usage_error({"clean", "none.obj", good}, "none.obj: cannot be read");
    check_usage_error({"clean", bad, good, "--fill", "0"}, "fill");
    check_usage_error({"demo", "vertex_star", "--mesh", bad},
                      "(with --clean it is mended)");
    check_usage_error({"demo", "vertex_star", "--clean"}, "--mesh");
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

namespace {

/// A student's folder: some exercises as they were handed out.
struct Student {
    TemporaryFolder folder;

    Said lab(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--work", folder.path()});
        return ::lab(std::move(arguments));
    }
    void solve(const std::string& name) const {
        write(name, read_file(exercise_named(name).solution()));
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(Desk{folder.path()}.file(exercise_named(name))) << text;
    }
};

}  // namespace

TEST_CASE("a student's way: reset, check, status, next, submit") {
    if (!has_solutions()) return;
    const Student student;
    for (const std::string name : {"tip", "face_sides", "prev"})
        REQUIRE(student.lab({"reset", name}).code == 0);
    student.solve("tip");
    CHECK(student.lab({"check", "tip"}).code == 0);
    // Without a name: the one that was checked last.
    CHECK(contains(student.lab({"check"}).text, "tip.cpp: accepted"));
    CHECK(contains(student.lab({"list", "arrives"}).text, "tip  "));
    CHECK(contains(student.lab({"list", "arrives"}).text, "solved"));
    student.write("tip", "no C++\n");
    const Said changed = student.lab({"status"});
    CHECK(contains(changed.text, "Changed since they were accepted: tip"));
    CHECK(student.lab({"check", "tip"}).code == 1);
    CHECK(contains(student.lab({"status"}).text, "tip was solved and is"));
    const Said all = student.lab({"check", "all"});
    CHECK(all.code == 1);
    CHECK(contains(all.text, "tip                    compile error"));
    CHECK(contains(all.text, "0 accepted, 1 not accepted, "));
    CHECK(student.lab({"next"}).code == 0);
}

TEST_CASE("submit packs what is begun, and says what is missing") {
    if (!has_solutions()) return;
    const Student student;
    CHECK(student.lab({"submit"}).code == 2);
    for (const std::string name : {"tip", "prev"})
        REQUIRE(student.lab({"reset", name}).code == 0);
    student.solve("tip");
    const fs::path archive = student.folder / "mine.zip";
    const Said one = student.lab({"submit", "tip", "--out", archive});
    INFO(one.text);
    CHECK(one.code == 0);
    const std::string bytes = read_file(archive);
    CHECK(bytes.rfind("PK\3\4", 0) == 0);
    CHECK(contains(bytes, "tip.cpp"));
    CHECK_FALSE(contains(bytes, "prev.cpp"));
    CHECK(contains(bytes, read_file(exercise_named("tip").solution())));
    const Said chapter = student.lab({"submit", "--out", archive});
    CHECK(chapter.code == 1);
    CHECK(contains(chapter.text, "Not in the archive:\n"));
    CHECK(contains(chapter.text, "00_table/prev"));
}

TEST_CASE("LAB_LANG=it gives Italian") {
    const Said hint = lab({"hint", "face_sides"}, {"LAB_LANG=it"});
    CHECK(contains(hint.text, "1. Prendi la tabella"));
    CHECK(contains(lab({"list", "tip"}, {"LAB_LANG=it"}).text,
                   "Dove arriva un half-edge"));
    const Said other = lab({"hint", "face_sides"}, {"LAB_LANG=fr"});
    CHECK(other.code == 2);
    CHECK(contains(other.text, "LAB_LANG is \"fr\""));
}

TEST_CASE("doctor tries the machine") {
    const Student student;
    const Said said = student.lab({"doctor"});
    INFO(said.text);
    CHECK(said.code == 0);
    CHECK(contains(said.text, "This machine is ready."));
}
