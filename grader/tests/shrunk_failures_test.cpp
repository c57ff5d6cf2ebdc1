// What students read who fail on generated meshes only: stored wrong
// submissions, checked by lab.
#include "grader/tests/golden.h"
#include "grader/tests/grader_program.h"

using namespace grader::tests;

namespace {

/// The answer of `lab check`; from the root of the project, so that paths in it
/// are the same everywhere.
Said lab_check(const std::string& exercise, const std::string& file) {
    course::Command command;
    command.arguments = {course::build_root() / "course" / "lab", "check",
                         exercise, "--file", file};
    command.environment = course::plain_environment();
    return says(command);
}

void check_told(const std::string& topic, const std::string& exercise,
                const std::string& mistake) {
    const std::string file =
        "grader/wrong/" + topic + "/" + exercise + "/" + mistake + ".cpp";
    const Said said = lab_check(exercise, file);
    INFO(said.text);
    CHECK(said.code == 1);
    CHECK(contains(said.text, ", shrunk from "));
    CHECK(lab_check(exercise, file).text == said.text);
    check_golden("shrunk_" + exercise + ".txt", said.text);
}

}  // namespace

TEST_CASE("a small mesh is shown to who fails on generated meshes only") {
    check_told("01_traversal", "face_sides", "wrong_answer/triangle_or_quad");
    check_told("01_traversal", "adjacent_faces", "wrong_answer/one_face_twice");
    check_told("01_traversal", "vertex_faces", "wrong_answer/sorted_set");
    check_told("02_border", "boundary_walk",
               "time_limit_exceeded/all_half_edges_without_a_face");
}
