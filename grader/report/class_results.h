// The results of a class, as every kind of report takes them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/runner/results.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/assignment.h"

namespace grader {

/// One exercise of the assignment.
struct GradedExercise {
    std::string exercise;  ///< "01_traversal/face_sides"
    double weight = 1;
    Suite suite;
    bool is_bonus = false;  ///< adds to totals, not to their maximum
};

/// What all students' results have in common.
struct GradedAssignment {
    Assignment assignment;
    std::vector<GradedExercise> exercises;
    Run run;  ///< the newest one, with its students; empty when there is none
    /// What the newest run recognises mistakes by.
    std::vector<KnownMistake> mistakes = {};
};

/// The assignment as the newest run graded it; students in the order of their
/// shown names, and of their ids. Throws GradebookError.
GradedAssignment graded_assignment(const Gradebook& gradebook,
                                   const Assignment& assignment);

/// What students may be told of hidden cases, at the time of the newest run.
FeedbackLevel hidden_feedback(const GradedAssignment& graded);

/// One student: the exercises are those of the assignment, in its order. With
/// meshes and printed texts this may be megabytes: have one at a time.
struct StudentResults {
    Student student;
    /// Without a value: not judged yet, as after a run that was cut short.
    std::vector<std::optional<course::ExerciseResult>> exercises;
    /// What an instructor set, by number of the exercise.
    std::map<std::size_t, GradeByHand> by_hand = {};
    Lateness late = {};  ///< in time where it is not known when it came
};

/// For each exercise the result that counts. Throws GradebookError.
StudentResults student_results(const Gradebook& gradebook,
                               const GradedAssignment& graded,
                               const Student& student);

/// What a grade is made of; all that tables of a class take of a result.
struct Score {
    course::Verdict verdict = course::Verdict::grader_fault;
    double points = 0;     ///< those that count
    bool by_hand = false;  ///< an instructor set them, whatever the verdict
};

/// The scores of one student, as StudentResults::exercises.
struct Scores : std::vector<std::optional<Score>> {
    using vector::vector;
    Lateness late = {};
    bool marked_late = false;  ///< see Student
};

/// What counts for that exercise; none when it has no result yet.
std::optional<Score> score_of(const StudentResults& student,
                              std::size_t exercise);
Scores scores_of(const StudentResults& student);

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

Status status(const Scores& student);

/// Weighted points, less what lateness costs, rounded as the assignment says.
/// `total` has no value where there is no grade: a fault of ours must never be
/// read as a low grade.
struct Total {
    std::optional<double> total;
    double max = 0;
    double late_cost = 0;  ///< points that were reached and do not count
};

Total total(const GradedAssignment& graded, const Scores& student);

/// "2 days late", "2 days late, 80 % counts", "marked as late by the platform";
/// empty when it came in time or that is not known.
std::string late_text(const Scores& student);

/// When it came, by the clocks of the assignment's zone; empty: not known.
std::string submitted_text(const GradedAssignment& graded,
                           const Student& student);

/// Whether some student was late, or was marked so.
bool has_late(const std::vector<Scores>& students);

/// Who they are on the platform, and without one the name of the folder.
const std::string& shown_name(const Student& student);

/// All who handed in: the members, or the student alone.
std::vector<Member> people_of(const Student& student);

/// Weighted points that every student could have reached, without bonus.
double max_total(const GradedAssignment& graded);

/// Points of one exercise that every student could have reached.
double max_points(const GradedAssignment& graded, std::size_t exercise);

/// The points of a result; none when there is no result, or a fault.
std::optional<double> points(const std::optional<Score>& score);

/// "1.5", "2 (bonus)".
std::string weight_text(const GradedExercise& exercise);

/// Whether some weight is not 1, or some exercise a bonus.
bool is_weighted(const GradedAssignment& graded);

/// Whether a file of the exercise was handed in and judged.
bool was_judged(const std::optional<Score>& score);

/// "7.5", "7.5*": points in a table; the star says that they were set by hand.
std::string points_mark(const Score& score);

/// Whether a table shows points beside the verdict.
bool shows_points(const std::optional<Score>& score);

/// The student of that id or, if there is none, of that folder name, or of that
/// name or number on the platform.
const Student* find_student(const std::vector<Student>& students,
                            std::string_view id_or_name);

/// "ok", "WA", "RE": a verdict in two letters, for narrow tables.
std::string_view mark(course::Verdict verdict);

/// The whole class in memory: for tests, which have small ones.
struct ClassResults : GradedAssignment {
    std::vector<StudentResults> students;  ///< in the order of run.students
};

ClassResults class_results(const Gradebook& gradebook,
                           const Assignment& assignment);
bool was_judged(const std::optional<course::ExerciseResult>& result);

}  // namespace grader
