// A class without what only a student's own page shows. It takes some hundred
// bytes for each student, where their results may take a megabyte.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grader/report/class_results.h"

namespace grader {

/// A case of a suite, and how many failed it.
struct CaseCount {
    std::string exercise;
    std::string name;
    course::Visibility visibility = course::Visibility::hidden;
    int failed = 0;
    int judged = 0;  ///< submissions that came so far as to run it
};

/// An exercise of a student that ended in a fault of the grader.
struct Fault {
    std::size_t student, exercise;  ///< numbers in the class's lists
    std::string message;            ///< shortened
};

/// A mistake that was recognised, and whose submissions have it.
struct MistakeCount {
    std::string mistake, hint;
    std::vector<std::size_t> students;  ///< numbers in the class's list
};

/// When a file was judged for the first time.
struct AttemptTime {
    Instant when;
    bool accepted = false;
};

/// Attempts at an exercise that is not accepted, the last of which brought no
/// more points than those before.
struct Stuck {
    std::size_t student, exercise;  ///< numbers in the class's lists
    int attempts = 0;
    int in_vain = 0;    ///< the last ones
    double best = 0;    ///< points
    std::string since;  ///< when they were reached first
};

/// Points of a student's exercise that an instructor set.
struct SetPoints {
    std::size_t student, exercise;  ///< numbers in the class's lists
    GradeByHand grade;
    double found = 0;  ///< the points that the grader found
};

struct ClassSummary : GradedAssignment {
    std::vector<Scores> students;  ///< in the order of run.students
    std::vector<Fault> faults;     ///< by student, then by exercise
    /// By number of the exercise and name of the case.
    std::map<std::pair<std::size_t, std::string>, CaseCount> cases;
    std::vector<SetPoints> by_hand = {};  ///< by student, then by exercise
    /// By number of the exercise and mistake.
    std::map<std::pair<std::size_t, std::string>, MistakeCount> recognised = {};
    std::vector<AttemptTime> attempts = {};
    std::vector<Stuck> stuck = {};  ///< by student, then by exercise
};

/// Adds a student. Precondition: it is the next one of run.students.
void add(ClassSummary& all, const StudentResults& student);

/// Adds the history of the student who was added last.
void add_history(ClassSummary& all, const std::vector<HistoryEntry>& history);

}  // namespace grader
