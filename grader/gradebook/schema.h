// The tables of a gradebook. A change here, or to what a blob holds, needs a
// new schema_version.
#pragma once

namespace grader {

/// In the file's header: how `file` and we tell a gradebook from any other.
inline constexpr int application_id = 0x48454762;  // "HEGb"
inline constexpr int schema_version = 3;

/// Columns named `student` hold safe ids. Times are ISO 8601 in UTC. Blobs are
/// in the encoding of course/runner/codec.h.
inline constexpr const char* schema = R"sql(
CREATE TABLE runs (
    run INTEGER PRIMARY KEY,
    started_at TEXT NOT NULL,
    version TEXT NOT NULL,
    sandbox TEXT NOT NULL,
    seed TEXT NOT NULL,  -- text: it has 64 bits and no sign
    jobs INTEGER NOT NULL,
    proposed INTEGER NOT NULL DEFAULT 0  -- 1: its results do not count yet
);
CREATE TABLE run_suites (
    run INTEGER NOT NULL REFERENCES runs,
    exercise TEXT NOT NULL,
    file TEXT NOT NULL,
    version TEXT NOT NULL,
    max REAL NOT NULL,
    UNIQUE (run, exercise)
);
CREATE TABLE run_students (
    run INTEGER NOT NULL REFERENCES runs,
    student TEXT NOT NULL,
    name TEXT NOT NULL,  -- the folder's name, any bytes
    UNIQUE (run, student)
);
CREATE TABLE run_notes (
    run INTEGER NOT NULL REFERENCES runs,
    student TEXT,  -- NULL: about the folder as a whole
    note TEXT NOT NULL
);
CREATE INDEX run_notes_by_student ON run_notes (run, student);
CREATE TABLE attempts (
    attempt INTEGER PRIMARY KEY,
    run INTEGER NOT NULL REFERENCES runs,
    student TEXT NOT NULL,
    exercise TEXT NOT NULL,
    key TEXT NOT NULL,
    verdict TEXT NOT NULL,
    points REAL NOT NULL,
    max REAL NOT NULL,
    message TEXT NOT NULL,
    finished_at TEXT NOT NULL
);
CREATE INDEX attempts_by_key ON attempts (student, exercise, key);
CREATE TABLE cases (
    attempt INTEGER NOT NULL REFERENCES attempts,
    position INTEGER NOT NULL,
    name TEXT NOT NULL,
    verdict TEXT NOT NULL,
    points REAL NOT NULL,      -- earned
    max REAL NOT NULL,
    visibility TEXT NOT NULL,  -- shown, hidden
    hint TEXT NOT NULL,
    printed TEXT NOT NULL,
    failures BLOB,
    PRIMARY KEY (attempt, position)
);
-- Which attempt counts, and since which run; the newest row holds.
CREATE TABLE counted (
    counted INTEGER PRIMARY KEY,
    run INTEGER NOT NULL REFERENCES runs,
    student TEXT NOT NULL,
    exercise TEXT NOT NULL,
    attempt INTEGER NOT NULL REFERENCES attempts
);
CREATE INDEX counted_by_student ON counted (student, exercise);
)sql";

/// What version 3 added for the history; a new gradebook gets it like an older
/// one.
inline constexpr const char* history_of_version_3 = R"sql(
ALTER TABLE runs ADD COLUMN user TEXT NOT NULL DEFAULT '';
-- SHA-256 of the file; '' when there was none, or before version 3.
ALTER TABLE attempts ADD COLUMN source TEXT NOT NULL DEFAULT '';
-- Grades that an instructor set; of a student and exercise the newest row holds.
CREATE TABLE set_by_hand (
    set_by_hand INTEGER PRIMARY KEY,
    student TEXT NOT NULL,
    exercise TEXT NOT NULL,
    points REAL,  -- NULL: taken back, what the grader found counts again
    reason TEXT NOT NULL,
    user TEXT NOT NULL,
    set_at TEXT NOT NULL
);
CREATE INDEX set_by_hand_by_student ON set_by_hand (student, exercise);
-- Stored wrong submissions by which the run recognised mistakes.
CREATE TABLE run_mistakes (
    run INTEGER NOT NULL REFERENCES runs,
    exercise TEXT NOT NULL,
    name TEXT NOT NULL,
    mistake TEXT NOT NULL,
    hint TEXT NOT NULL,  -- for students; may be empty
    fingerprint TEXT NOT NULL
);
CREATE INDEX run_mistakes_by_run ON run_mistakes (run);
)sql";

/// What version 3 added for students who come from a course platform; a new
/// gradebook gets it like an older one.
inline constexpr const char* people_of_version_3 = R"sql(
ALTER TABLE run_students ADD COLUMN person TEXT NOT NULL DEFAULT '';
-- What the platform's own tables know them by.
ALTER TABLE run_students ADD COLUMN key TEXT NOT NULL DEFAULT '';
ALTER TABLE run_students ADD COLUMN submitted_at TEXT;  -- NULL: not known
ALTER TABLE run_students ADD COLUMN marked_late INTEGER NOT NULL DEFAULT 0;
CREATE TABLE run_members (
    run INTEGER NOT NULL REFERENCES runs,
    student TEXT NOT NULL,
    name TEXT NOT NULL,
    number TEXT NOT NULL,
    email TEXT NOT NULL
);
CREATE INDEX run_members_by_student ON run_members (run, student);
)sql";

/// One row per student and exercise, for instructors. `points` are those that
/// the grader found; where `set_points` is not NULL, it counts instead.
inline constexpr const char* standing_view = R"sql(
CREATE VIEW standing AS
    SELECT a.student, a.exercise, a.verdict, a.points, a.max, a.finished_at,
           a.attempt,
           (SELECT h.points FROM set_by_hand h WHERE h.student = a.student
            AND h.exercise = a.exercise
            ORDER BY h.set_by_hand DESC LIMIT 1) AS set_points
    FROM attempts a JOIN counted c ON c.attempt = a.attempt
    WHERE c.counted = (SELECT max(d.counted) FROM counted d NATURAL JOIN runs
                       WHERE d.student = a.student
                       AND d.exercise = a.exercise AND NOT proposed);
)sql";

/// From version 1, which had no proposed runs.
inline constexpr const char* from_version_1 = R"sql(
ALTER TABLE runs ADD COLUMN proposed INTEGER NOT NULL DEFAULT 0;
)sql";

}  // namespace grader
