// What a judge reports: the cases that it is going to run, then what became of
// each. Grades are made from this and from nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "course/runner/verdict.h"

namespace course {

/// Whether a student may see what a case does, or only its name and hint.
enum class Visibility : std::uint8_t { shown, hidden };

/// A test case as it stands in the suite.
struct CaseInfo {
    std::string name;
    double points = 0;
    Visibility visibility = Visibility::hidden;
};

/// The mesh that a failure happened on, enough to draw it.
struct MeshPicture {
    std::string name;
    std::vector<HalfEdge> rows;   ///< empty when the mesh is too large
    std::vector<Vec3> positions;  ///< may be empty
};

/// One failed check: what was asked, what was expected, what came.
struct Failure {
    std::string call;      ///< "face_sides(he, 4)"
    std::string expected;  ///< "4"
    std::string got;       ///< "0", or what went wrong instead of an answer
    std::string note;      ///< INFO texts of the suite
    MeshPicture mesh;
    std::vector<Visit> walk;  ///< the last reads of the call, oldest first
    std::int64_t reads = 0;   ///< how many there were in all
};

/// What became of one case.
struct CaseResult {
    CaseInfo info;
    Verdict verdict = Verdict::grader_fault;
    std::vector<Failure> failures;  ///< the first few
    std::string hint;               ///< from the author of the suite
    std::string printed;            ///< what the submission printed, cleaned
};

/// What became of one exercise of one submission.
struct ExerciseResult {
    Verdict verdict = Verdict::grader_fault;
    std::string message;  ///< compiler output, or what the grader's fault was
    std::vector<CaseResult> cases;

    double points() const;
    double max() const;
};

}  // namespace course
