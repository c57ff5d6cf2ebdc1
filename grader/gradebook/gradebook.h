// The gradebook: every run and every result that was ever reached, in one
// SQLite file that an instructor may also ask in plain SQL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "course/runner/results.h"
#include "grader/gradebook/member.h"

namespace SQLite {
class Exception;
}

namespace grader {

/// A gradebook that cannot be used. Each cause has a type of its own; the
/// message names the file, what was found and what was expected.
struct GradebookError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// There is no such file, or no place for one.
struct GradebookMissing : GradebookError {
    using GradebookError::GradebookError;
};
/// Another process has held it for longer than we wait.
struct GradebookLocked : GradebookError {
    using GradebookError::GradebookError;
};
struct GradebookReadOnly : GradebookError {
    using GradebookError::GradebookError;
};
/// The disk has no room for it.
struct GradebookFull : GradebookError {
    using GradebookError::GradebookError;
};
/// Not a SQLite file, or one of another program.
struct GradebookForeign : GradebookError {
    using GradebookError::GradebookError;
};
/// Written by a newer version of this program.
struct GradebookNewer : GradebookError {
    using GradebookError::GradebookError;
};
struct GradebookDamaged : GradebookError {
    using GradebookError::GradebookError;
};

/// A student as the run found them.
struct Student {
    std::string id;    ///< safe in file names; the key of every table
    std::string name;  ///< the folder's name: any bytes, data only
    std::vector<std::string> notes;  ///< files ignored or refused, and why
    /// What the course platform calls them and knows them by; empty where the
    /// class came from plain folders.
    std::string person = {}, key = {};
    std::optional<std::string> submitted_at = {};  ///< ISO 8601, UTC
    bool marked_late = false;                      ///< by the platform
    /// All who handed this in, where the platform says so.
    std::vector<Member> members = {};

    friend bool operator==(const Student&, const Student&) = default;
};

/// The suite of one exercise, as the run used it.
struct Suite {
    std::string exercise;  ///< "01_traversal/face_sides"
    std::string file;      ///< what a student hands in: "face_sides.cpp"
    std::string version;   ///< changes when the suite changes
    double max = 0;        ///< points of all its cases

    friend bool operator==(const Suite&, const Suite&) = default;
};

/// The facts of one run of the grader.
struct Run {
    std::string started_at;  ///< ISO 8601, UTC
    std::string version;     ///< of the grader
    std::string sandbox;     ///< how submissions were isolated
    std::uint64_t seed = 0;
    int jobs = 1;
    /// Whether its results only lie ready until accept() is called.
    bool proposed = false;
    std::string user = {};  ///< who ran it: the name of the account
    std::vector<Suite> suites;
    std::vector<Student> students;   ///< every one found
    std::vector<std::string> notes;  ///< about the folder as a whole

    friend bool operator==(const Run&, const Run&) = default;
};

/// A run of the past and its number; without its students and notes.
struct PastRun {
    int number = 0;
    Run facts;
};

/// One exercise of one student, judged. An exercise that was not handed in is
/// recorded too, with verdict not_submitted and a key of its own.
struct Attempt {
    std::string student;   ///< Student::id
    std::string exercise;  ///< Suite::exercise
    std::string key;       ///< hash of all that the result depends on
    course::ExerciseResult result;
    std::string finished_at;  ///< ISO 8601, UTC
    std::string source = {};  ///< SHA-256 of the file; empty when there is none
};

/// The points of an exercise as an instructor set them.
struct GradeByHand {
    std::string student;   ///< Student::id
    std::string exercise;  ///< Suite::exercise
    /// Without a value: taken back, what the grader found counts again.
    std::optional<double> points;
    std::string reason;
    std::string user;    ///< who did it: the name of the account
    std::string set_at;  ///< ISO 8601, UTC
};

/// A stored wrong submission, as a run recognised mistakes by it.
struct KnownMistake {
    std::string exercise;     ///< Suite::exercise
    std::string name;         ///< of its file: "stops_at_the_vertex"
    std::string mistake;      ///< what is wrong with it, for instructors
    std::string hint;         ///< for students; may be empty
    std::string fingerprint;  ///< of its result (see pipeline/mistakes.h)
};

/// Something that happened to a grade.
struct HistoryEntry {
    enum class Kind {
        judged,         ///< a file was judged, or was found not to be there
        counted_again,  ///< an earlier result counts once more
        set_by_hand,
        taken_back,  ///< what was set by hand
    };

    std::string when;  ///< ISO 8601, UTC
    Kind kind = Kind::judged;
    std::string student;   ///< Student::id
    std::string exercise;  ///< Suite::exercise
    double points = 0;
    std::string user;  ///< whose run it was, or who set the points
    // Of what was judged or counts again:
    int run = 0;
    std::string suite = {};  ///< its version
    course::Verdict verdict = course::Verdict::grader_fault;
    double max = 0;
    std::string source = {};  ///< Attempt::source
    bool proposed = false;    ///< its run only proposes it
    // Of what was set by hand or taken back:
    std::string reason = {};
};

/// A grade that a proposed run would change.
struct Change {
    std::string student;   ///< Student::id
    std::string exercise;  ///< Suite::exercise
    /// Without a value: there is no result that counts.
    std::optional<course::Verdict> old_verdict;
    double old_points = 0;
    course::Verdict verdict = course::Verdict::grader_fault;
    double points = 0;
};

/// One open gradebook. Every change is one transaction, and rows are only ever
/// added. For one thread at a time; several processes may use one file.
///
/// While it is written, the file is in SQLite's WAL mode, synchronous NORMAL.
/// A process that is killed at any moment leaves each change whole or not at
/// all, and all that were reported done: they are in the system's hands. A
/// power failure may take the last few results, which are then graded again,
/// but never damages the file. The rollback journal is no safer against a kill
/// and costs 20 ms of waiting for the disk per result instead of 0.2.
/// Closing goes back to the rollback journal, so that a gradebook at rest is
/// one file, which can be copied and be read where nothing may be written; only
/// after a kill a second file, `-wal`, belongs to it until it is next opened.
class Gradebook {
public:
    enum class Access {
        write,  ///< creates the file when there is none
        read,   ///< the file must exist; it may be read-only
    };

    /// Opens, and checks that it is a gradebook of a known version.
    /// Throws a GradebookError, as every member function does.
    explicit Gradebook(const std::filesystem::path& file,
                       Access access = Access::write);
    ~Gradebook();
    Gradebook(Gradebook&&) noexcept;
    Gradebook& operator=(Gradebook&&) noexcept;

    /// Writes down a run with its students and suites; returns its number.
    /// Precondition: ids of students and names of suites are unique.
    int begin_run(const Run& run);

    /// The newest run that is not only proposed, if there is one.
    std::optional<Run> last_run() const;

    /// All runs, proposed ones too, in their order.
    std::vector<PastRun> runs() const;

    /// The results that a proposed run reached or found, where another one
    /// counts: in the order of students and exercises.
    std::vector<Change> changes(int run) const;

    /// What a proposed run reached or found counts from now on.
    void accept(int run);

    /// Adds an attempt; from now on it is the one that counts for its student
    /// and exercise, unless its run is only proposed. `run` is what begin_run
    /// returned.
    void record(int run, const Attempt& attempt);

    /// The newest result of this student, exercise and key that is not a
    /// grader fault: faults are retried.
    std::optional<course::ExerciseResult> find(std::string_view student,
                                               std::string_view exercise,
                                               std::string_view key) const;

    /// Whether find has a result; it counts again: a student who goes back to
    /// an earlier version gets the points of that version.
    bool reuse(int run, std::string_view student, std::string_view exercise,
               std::string_view key);

    /// The attempt that counts for this student and exercise, if any.
    std::optional<Attempt> latest(std::string_view student,
                                  std::string_view exercise) const;

    /// The attempts that count for this student, one per exercise, by its name.
    std::vector<Attempt> latest(std::string_view student) const;

    /// The exercises and verdicts of results that count, or will when that run
    /// is accepted, where some cases passed and others did not.
    std::set<std::pair<std::string, course::Verdict>> partly_failed(
        int run) const;

    /// Writes down what a run knows of mistakes.
    void add_mistakes(int run, const std::vector<KnownMistake>& known);

    /// What the newest run that is not only proposed knew.
    std::vector<KnownMistake> mistakes() const;

    /// Adds a row; what was set or judged before stays. It holds for all later
    /// results, too, until it is taken back.
    void set_by_hand(const GradeByHand& grade);

    /// The grades set by hand that hold for this student, by exercise.
    std::vector<GradeByHand> set_by_hand(std::string_view student) const;

    /// Everything that happened to this student's grades, oldest first.
    std::vector<HistoryEntry> history(std::string_view student) const;

    /// Every student with a history, by id, with their newest name.
    std::vector<Student> students_ever() const;

    /// The results that counted when the run `newer` ended, where another one
    /// or none counted when `older` ended; in the order of students and
    /// exercises. Of grades set by hand it knows nothing.
    std::vector<Change> differences(int older, int newer) const;

private:
    struct Database;
    std::unique_ptr<Database> database_;
};

}  // namespace grader
