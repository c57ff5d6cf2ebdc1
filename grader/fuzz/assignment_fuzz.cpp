// Assignment files: any bytes are an assignment or a list of mistakes.
#include "grader/pipeline/assignment.h"

#include <algorithm>

#include "grader/fuzz/fuzz.h"

namespace {

const std::vector<std::string> known = {"00_table/tip", "00_table/validate",
                                        "01_traversal/face_sides",
                                        "02_border/edge_kind"};

void check(const grader::Assignment& assignment) {
    fuzz::require(!assignment.name.empty(), "an assignment has a name");
    fuzz::require(assignment.exercises.size() <= known.size(),
                  "an exercise comes once");
    for (const grader::Assignment::Item& item : assignment.exercises) {
        fuzz::require(
            std::find(known.begin(), known.end(), item.exercise) != known.end(),
            "exercises are known ones");
        fuzz::require(item.weight > 0 && item.weight <= 1000,
                      "weights are in range");
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile input;
    try {
        check(grader::read_assignment(input.with(fuzz::text_of(data, size)),
                                      known));
    } catch (const grader::AssignmentError& error) {
        fuzz::require(!error.mistakes.empty(), "a refused file has a mistake");
    }
    return 0;
}
