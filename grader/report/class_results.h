// The results of a class, as every kind of report takes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/results.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/assignment.h"

namespace grader {

/// One student: the exercises are those of the assignment, in its order.
struct StudentResults {
    Student student;
    /// Without a value: not judged yet, as after a run that was cut short.
    std::vector<std::optional<course::ExerciseResult>> exercises;
};

/// One exercise of the assignment.
struct GradedExercise {
    std::string exercise;  ///< "01_traversal/face_sides"
    double weight = 1;
    Suite suite;
};

struct ClassResults {
    Assignment assignment;
    std::vector<GradedExercise> exercises;
    std::vector<StudentResults> students;  ///< in the order of the run
    Run run;                               ///< the newest one
};

/// The students of the newest run and, for each exercise of the assignment,
/// the result that counts. Without a run there are no students.
/// Throws GradebookError.
ClassResults class_results(const Gradebook& gradebook,
                           const Assignment& assignment);

/// How far a student's grade has come, by the first of these that holds.
enum class Status {
    grader_fault,       ///< an exercise ended in one: there is no total
    not_judged,         ///< an exercise has no result yet: there is no total
    nothing_submitted,  ///< no file of any exercise
    partial,            ///< files of some exercises are missing
    complete,           ///< every exercise was handed in and judged
};

/// "grader fault", "not judged", "nothing submitted", "partial", "complete".
std::string_view words(Status status);

Status status(const StudentResults& student);

/// Weighted points. `total` has no value where there is no grade: a fault of
/// ours must never be read as a low grade.
struct Total {
    std::optional<double> total;
    double max = 0;
};

Total total(const ClassResults& results, const StudentResults& student);

/// Points of one exercise that every student could have reached.
double max_points(const ClassResults& results, std::size_t exercise);

/// The points of a result; none when there is no result, or a fault.
std::optional<double> points(const std::optional<course::ExerciseResult>&);

/// Whether some weight is not 1.
bool is_weighted(const ClassResults& results);

/// Whether a file of the exercise was handed in and judged.
bool was_judged(const std::optional<course::ExerciseResult>& result);

/// The student of that id or, if there is none, of that folder name.
const StudentResults* find_student(const ClassResults& results,
                                   std::string_view id_or_name);

/// "ok", "WA", "RE": a verdict in two letters, for narrow tables.
std::string_view mark(course::Verdict verdict);

}  // namespace grader
