// `grader run` of an archive, from the command to the student's page.
#include <sys/wait.h>

#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "grader/sandbox/sandbox.h"
#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

struct Said {
    int code = -1;
    std::string text;
};

Said run_class(const std::filesystem::path& dir,
               const std::filesystem::path& out) {
    course::Command command;
    command.arguments = {course::build_root() / "grader" / "grader", "run", dir,
                         "--out", out};
    command.environment = course::plain_environment();
    const course::Finished finished =
        course::run(command, std::chrono::seconds(300), std::size_t{1} << 22);
    REQUIRE(WIFEXITED(finished.status));
    return {WEXITSTATUS(finished.status), finished.output};
}

bool has_sandbox() {
    const Stage stage;
    const Probe probe = grader::probe(stage);
    if (probe.isolation != Isolation::none) return true;
    WARN("skipped, no isolation on this machine: " << probe.reason);
    return false;
}

const std::string right =
    "#include \"exercises/01_traversal/face_sides.h\"\n"
    "int face_sides(const HalfEdgeTable& he, int i) {\n"
    "    if (he[i].fi == -1) return 0;\n    int start = i, sides = 0;\n"
    "    do { ++sides; i = he[i].next; } while (i != start);\n"
    "    return sides;\n}\n";

}  // namespace

TEST_CASE(
    "a class in an archive is graded, and students see what was refused") {
    if (!has_sandbox()) return;
    ClassOnDisk all;
    all.file(
        "class.zip",
        packed(
            zip,
            {{"anna/homework.tgz", packed(tar_gz, {{"face_sides.cpp", right}})},
             {"mallory/a.zip", zip_of({{"../<b>face_sides.cpp", right}})}}));
    const auto out = all.at("out");
    const Said said = run_class(all.at("class.zip"), out);
    INFO(said.text);
    CHECK(said.code == 0);
    const std::string page =
        file_contents(out / "students" / "mallory" / "feedback.html");
    CHECK_THAT(page, Containing("a.zip/../&lt;b&gt;face_sides.cpp: leads out "
                                "of its folder"));
    CHECK_THAT(file_contents(out / "students" / "anna" / "feedback.html"),
               Containing("face_sides"));
    const std::string grades = file_contents(out / "grades.csv");
    INFO(grades);
    CHECK_THAT(grades, Containing("anna,11,"));
    CHECK_THAT(grades, Containing("mallory,0,"));
}

TEST_CASE("a broken archive of a class is wrong usage and grades nobody") {
    ClassOnDisk all;
    const std::string bytes = packed(zip, {{"anna/face_sides.cpp", right}});
    all.file("class.zip", bytes.substr(0, bytes.size() - 10));
    const Said said = run_class(all.at("class.zip"), all.at("out"));
    INFO(said.text);
    CHECK(said.code == 2);
    CHECK_THAT(said.text, Containing("class.zip: the zip file is cut short"));
    CHECK_FALSE(std::filesystem::exists(all.at("out") / "grades.csv"));
}
