// The autograder's archive for Gradescope: what is in it, and its run acted out
// in a folder that stands for /autograder, with the grader that is built here.
#include <fstream>
#include <nlohmann/json.hpp>

#include "course/runner/temporary_folder.h"
#include "grader/tests/grader_program.h"

using namespace grader::tests;

namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

course::Command command(const std::vector<std::string>& arguments) {
    course::Command command;
    command.arguments = arguments;
    command.environment = course::plain_environment();
    return command;
}

/// A folder as Gradescope's containers have it, with the archive unpacked.
class Autograder {
public:
    Autograder() {
        write(folder_ / "assignment.toml",
              "name = \"One\"\n[exercises]\nface_sides = 2\nprev = 1\n");
        const Said made =
            grader_says({"release", "--gradescope", zip(), "--assignment",
                         folder_ / "assignment.toml"});
        INFO(made.text);
        REQUIRE(made.code == 0);
        fs::create_directories(root() / "source");
        REQUIRE(says(command({"cmake", "-E", "chdir", root() / "source",
                              "cmake", "-E", "tar", "xf", zip()}))
                    .code == 0);
    }

    fs::path zip() const { return folder_ / "autograder.zip"; }
    fs::path root() const { return folder_ / "autograder"; }

    /// As a student uploads it.
    Autograder& submit(const std::string& name, const std::string& text) {
        write(root() / "submission" / name, text);
        return *this;
    }

    /// What Gradescope reads after a run with that grader.
    nlohmann::json run(const fs::path& grader) const {
        course::Command run = command({root() / "source" / "run_autograder"});
        run.environment.push_back("AUTOGRADER_ROOT=" + root().string());
        run.environment.push_back("AUTOGRADER_GRADER=" + grader.string());
        const Said said = says(run);
        INFO(said.text);
        std::ifstream in(root() / "results" / "results.json");
        REQUIRE(in);
        return nlohmann::json::parse(in);
    }

private:
    course::TemporaryFolder folder_;
};

fs::path built_grader() {
    return course::build_root() / "grader" / "grader";
}

std::string reference(const std::string& exercise) {
    return course::read_file(course::exercise_named(exercise).solution());
}

std::string skeleton(const std::string& exercise) {
    return course::read_file(course::exercise_named(exercise).skeleton());
}

void check_is_fault(const nlohmann::json& results) {
    INFO(results.dump(2));
    CHECK_FALSE(results.contains("score"));
    CHECK(results.at("tests").empty());
    CHECK(contains(results.at("output"), "no fault of yours"));
}

}  // namespace

TEST_CASE("the archive has two scripts, the assignment and the tree") {
    const Autograder autograder;
    const fs::path source = autograder.root() / "source";
    for (const char* script : {"setup.sh", "run_autograder"}) {
        INFO(script);
        const auto rights = fs::status(source / script).permissions();
        CHECK((rights & fs::perms::owner_exec) != fs::perms::none);
    }
    CHECK(contains(course::read_file(source / "assignment.toml"),
                   "face_sides = 2"));
    for (const char* file :
         {"CMakeLists.txt", "course/setup.sh", "grader/grader",
          "exercises/01_traversal/face_sides.h",
          "solutions/01_traversal/face_sides.cpp",
          "grader/suites/01_traversal/face_sides_test.cpp"}) {
        INFO(file);
        CHECK(fs::exists(source / "tree" / file));
    }
    for (const char* folder : {".build", ".git", "data/sample_class"}) {
        INFO(folder);
        CHECK_FALSE(fs::exists(source / "tree" / folder));
    }
}

TEST_CASE("a submission gets the grade of its files") {
    if (!has_sandbox()) return;
    Autograder autograder;
    autograder.submit("face_sides.cpp", reference("face_sides"))
        .submit("week 1/prev.cpp", skeleton("prev"));
    const nlohmann::json results = autograder.run(built_grader());
    INFO(results.dump(2));
    CHECK(results.at("score") == 22);
    CHECK(results.at("extra_data").at("max") == 33);
    CHECK(results.at("extra_data").at("assignment") == "One");
    CHECK(results.at("tests").size() > 5);
}

TEST_CASE("an empty submission is graded, too") {
    if (!has_sandbox()) return;
    Autograder autograder;
    fs::create_directories(autograder.root() / "submission");
    CHECK(autograder.run(built_grader()).at("score") == 0);
}

TEST_CASE("a fault of ours leaves results without a score") {
    Autograder autograder;
    autograder.submit("face_sides.cpp", reference("face_sides"));
    for (const char* grader :
         {"/nonexistent/grader", "/bin/false", "/bin/true"}) {
        INFO(grader);
        check_is_fault(autograder.run(grader));
    }
}

TEST_CASE("no submission at all is a fault of ours") {
    check_is_fault(Autograder().run(built_grader()));
}

TEST_CASE("an assignment is needed for it") {
    const Said said = grader_says({"release", "--gradescope", "x.zip"});
    CHECK(said.code == 2);
    CHECK(contains(said.text, "--assignment"));
}
