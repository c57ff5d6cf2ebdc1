// What the gradebook knows of the past, and what was set by hand.
#include <algorithm>
#include <utility>

#include "grader/gradebook/database.h"

namespace grader {

namespace {

HistoryEntry judged_entry(const std::string& file, SQLite::Statement& row) {
    HistoryEntry entry;
    entry.run = row.getColumn(0).getInt();
    if (row.getColumn(1).getInt() != entry.run)
        entry.kind = HistoryEntry::Kind::counted_again;
    entry.when = row.getColumn(2).getString();
    entry.student = row.getColumn(3).getString();
    entry.exercise = row.getColumn(4).getString();
    entry.verdict = stored_verdict(file, row.getColumn(5).getString());
    entry.points = row.getColumn(6).getDouble();
    entry.max = row.getColumn(7).getDouble();
    entry.source = row.getColumn(8).getString();
    entry.user = row.getColumn(9).getString();
    entry.proposed = row.getColumn(10).getInt() != 0;
    entry.suite = row.getColumn(11).getString();
    return entry;
}

std::vector<HistoryEntry> judged(const std::string& file, Connection& db,
                                 const std::string& student) {
    // A result that counts again does so since its run began.
    auto rows = prepared(
        db,
        "SELECT c.run, a.run, CASE WHEN a.run = c.run THEN a.finished_at ELSE "
        "r.started_at END, a.student, a.exercise, a.verdict, a.points, a.max, "
        "a.source, r.user, r.proposed, coalesce(s.version, '') "
        "FROM counted c JOIN attempts a USING (attempt) "
        "JOIN runs r ON r.run = c.run LEFT JOIN run_suites s "
        "ON s.run = c.run AND s.exercise = c.exercise "
        "WHERE c.student = ? ORDER BY c.counted",
        student);
    std::vector<HistoryEntry> entries;
    while (rows->executeStep()) entries.push_back(judged_entry(file, *rows));
    return entries;
}

GradeByHand grade_by_hand(SQLite::Statement& row) {
    GradeByHand grade;
    grade.student = row.getColumn(0).getString();
    grade.exercise = row.getColumn(1).getString();
    if (!row.getColumn(2).isNull()) grade.points = row.getColumn(2).getDouble();
    grade.reason = row.getColumn(3).getString();
    grade.user = row.getColumn(4).getString();
    grade.set_at = row.getColumn(5).getString();
    return grade;
}

HistoryEntry entry_of(const GradeByHand& grade) {
    HistoryEntry entry;
    entry.when = grade.set_at;
    entry.kind = grade.points ? HistoryEntry::Kind::set_by_hand
                              : HistoryEntry::Kind::taken_back;
    entry.student = grade.student;
    entry.exercise = grade.exercise;
    entry.points = grade.points.value_or(0);
    entry.user = grade.user;
    entry.reason = grade.reason;
    return entry;
}

void add_by_hand(std::vector<HistoryEntry>& entries, Connection& db,
                 const std::string& student) {
    auto rows = prepared(db,
                         "SELECT student, exercise, points, reason, user, "
                         "set_at FROM set_by_hand WHERE student = ? "
                         "ORDER BY set_by_hand",
                         student);
    while (rows->executeStep())
        entries.push_back(entry_of(grade_by_hand(*rows)));
}

}  // namespace

void Gradebook::set_by_hand(const GradeByHand& grade) {
    guarded(database_->file, [&] {
        auto row = prepared(database_->db,
                            "INSERT INTO set_by_hand (student, exercise, "
                            "reason, user, set_at, points) "
                            "VALUES (?, ?, ?, ?, ?, ?)",
                            grade.student, grade.exercise, grade.reason,
                            grade.user, grade.set_at);
        if (grade.points)
            row->bind(6, *grade.points);
        else
            row->bind(6);
        row->exec();
    });
}

std::vector<GradeByHand> Gradebook::set_by_hand(
    std::string_view student) const {
    return guarded(database_->file, [&] {
        // Beside max(), SQLite gives the other columns of the same row.
        auto rows = prepared(database_->db,
                             "SELECT student, exercise, points, reason, user, "
                             "set_at, max(set_by_hand) FROM set_by_hand "
                             "WHERE student = ? GROUP BY exercise",
                             std::string(student));
        std::vector<GradeByHand> grades;
        while (rows->executeStep())
            if (GradeByHand one = grade_by_hand(*rows); one.points)
                grades.push_back(std::move(one));
        return grades;
    });
}

std::vector<HistoryEntry> Gradebook::history(std::string_view student) const {
    return guarded(database_->file, [&] {
        const std::string id(student);
        auto entries = judged(database_->file, database_->db, id);
        add_by_hand(entries, database_->db, id);
        std::stable_sort(
            entries.begin(), entries.end(),
            [](const auto& a, const auto& b) { return a.when < b.when; });
        return entries;
    });
}

std::vector<Student> Gradebook::students_ever() const {
    return guarded(database_->file, [&] {
        auto rows = prepared(database_->db,
                             "SELECT student, name, max(run) FROM run_students "
                             "GROUP BY student ORDER BY student");
        std::vector<Student> all;
        while (rows->executeStep())
            all.push_back({rows->getColumn(0).getString(),
                           rows->getColumn(1).getString(),
                           {}});
        return all;
    });
}

std::vector<Change> Gradebook::differences(int older, int newer) const {
    return guarded(database_->file, [&] {
        auto rows = prepared(
            database_->db,
            "WITH seen AS (SELECT c.* FROM counted c JOIN runs r USING (run) "
            "WHERE NOT r.proposed OR r.run IN (?1, ?2)), "
            "o AS (SELECT student, exercise, attempt, max(counted) FROM seen "
            "WHERE run <= ?1 GROUP BY student, exercise), "
            "n AS (SELECT student, exercise, attempt, max(counted) FROM seen "
            "WHERE run <= ?2 GROUP BY student, exercise) "
            "SELECT n.student, n.exercise, b.verdict, b.points, a.verdict, "
            "a.points FROM n JOIN attempts a ON a.attempt = n.attempt "
            "LEFT JOIN o ON o.student = n.student AND o.exercise = n.exercise "
            "LEFT JOIN attempts b ON b.attempt = o.attempt "
            "WHERE o.attempt IS NOT n.attempt ORDER BY n.student, n.exercise",
            older, newer);
        return changes_in(database_->file, *rows);
    });
}

}  // namespace grader
