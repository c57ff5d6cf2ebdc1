#include "grader/gradebook/gradebook.h"

#include <charconv>
#include <utility>

#include "grader/gradebook/database.h"
#include "grader/gradebook/schema.h"

namespace grader {

namespace {

using course::CaseResult;
using course::ExerciseResult;
using course::Failure;

// ---- opening

int number(SQLite::Database& sql, const char* text) {
    return sql.execAndGet(text).getInt();
}

bool is_fresh(SQLite::Database& sql) {
    return number(sql, "PRAGMA application_id") == 0 &&
           number(sql, "PRAGMA user_version") == 0 &&
           number(sql, "SELECT count(*) FROM sqlite_master") == 0;
}

void check_kind(const std::string& file, SQLite::Database& sql) {
    const int id = number(sql, "PRAGMA application_id");
    if (id != application_id)
        throw GradebookForeign(fmt::format(
            "{}: its application id is {}; expected {}, that of a gradebook",
            file, id, application_id));
    const int version = number(sql, "PRAGMA user_version");
    if (version > schema_version)
        throw GradebookNewer(fmt::format(
            "{}: has schema {}; expected at most {}: a newer grader wrote it",
            file, version, schema_version));
    if (version < 1)
        throw GradebookDamaged(
            fmt::format("{}: has schema {}; expected 1 to {}", file, version,
                        schema_version));
}

void create_tables(SQLite::Database& sql) {
    sql.exec(schema);
    sql.exec(fmt::format("PRAGMA application_id = {}", application_id));
}

/// Precondition: check_kind has passed, or the tables are new.
void bring_up_to_date(SQLite::Database& sql) {
    const int version = number(sql, "PRAGMA user_version");
    if (version < schema_version) {
        sql.exec("DROP VIEW IF EXISTS standing");
        if (version == 1) sql.exec(from_version_1);
        sql.exec(history_of_version_3);
        sql.exec(people_of_version_3);
        sql.exec(standing_view);
    }
    sql.exec(fmt::format("PRAGMA user_version = {}", schema_version));
}

void prepare_for_reading(const std::string& file, SQLite::Database& sql) {
    check_kind(file, sql);
    if (number(sql, "PRAGMA user_version") == schema_version) return;
    SQLite::Transaction all(sql, SQLite::TransactionBehavior::IMMEDIATE);
    bring_up_to_date(sql);
    all.commit();
}

/// Two processes may come here at the same moment: the look and the creation
/// are one transaction. It always writes, so that a folder in which nothing
/// can be written shows now, and not after the first submission.
void prepare_for_writing(const std::string& file, SQLite::Database& sql) {
    if (sqlite3_db_readonly(sql.getHandle(), "main") == 1)
        throw GradebookReadOnly(fmt::format(
            "{}: may only be read; expected a file that may be written", file));
    {
        SQLite::Transaction all(sql, SQLite::TransactionBehavior::IMMEDIATE);
        const bool fresh = is_fresh(sql);
        if (fresh) create_tables(sql);
        if (!fresh) check_kind(file, sql);
        bring_up_to_date(sql);
        all.commit();
    }
    // May fail while another process uses the file: then that one has set it.
    sql.tryExec("PRAGMA journal_mode = WAL");
    sql.exec("PRAGMA synchronous = NORMAL");
    sql.exec("PRAGMA foreign_keys = ON");
}

int flags(Gradebook::Access access) {
    // Reading, too, may have to roll back what a killed run left.
    return access == Gradebook::Access::read
               ? SQLite::OPEN_READWRITE
               : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE;
}

// ---- runs

void insert_run(Connection& db, const Run& run) {
    execute(db,
            "INSERT INTO runs (started_at, version, sandbox, seed, jobs, "
            "proposed, user) VALUES (?, ?, ?, ?, ?, ?, ?)",
            run.started_at, run.version, run.sandbox, std::to_string(run.seed),
            run.jobs, run.proposed ? 1 : 0, run.user);
}

void insert_note(Connection& db, int run, const std::string& note) {
    execute(db, "INSERT INTO run_notes (run, note) VALUES (?, ?)", run, note);
}

void insert_student(Connection& db, int run, const Student& student) {
    auto row =
        prepared(db,
                 "INSERT INTO run_students (run, student, name, person, key, "
                 "marked_late, submitted_at) VALUES (?, ?, ?, ?, ?, ?, ?)",
                 run, student.id, student.name, student.person, student.key,
                 student.marked_late ? 1 : 0);
    if (student.submitted_at)
        row->bind(7, *student.submitted_at);
    else
        row->bind(7);
    row->exec();
    for (const std::string& note : student.notes)
        execute(db, "INSERT INTO run_notes VALUES (?, ?, ?)", run, student.id,
                note);
    for (const Member& one : student.members)
        execute(db, "INSERT INTO run_members VALUES (?, ?, ?, ?, ?)", run,
                student.id, one.name, one.number, one.email);
}

std::uint64_t seed_of(const std::string& file, const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    if (error != std::errc() || stop != end)
        throw GradebookDamaged(fmt::format(
            "{}: a run has the seed '{}'; expected a number", file, text));
    return seed;
}

/// What stands in the row of the run itself.
Run run_facts(const std::string& file, SQLite::Statement& row) {
    Run run;
    run.started_at = row.getColumn(1).getString();
    run.version = row.getColumn(2).getString();
    run.sandbox = row.getColumn(3).getString();
    run.seed = seed_of(file, row.getColumn(4).getString());
    run.jobs = row.getColumn(5).getInt();
    run.user = row.getColumn(6).getString();
    run.proposed = row.getColumn(7).getInt() != 0;
    return run;
}

std::vector<std::string> notes_of(Connection& db, int run) {
    auto rows = prepared(db,
                         "SELECT note FROM run_notes WHERE run = ? AND "
                         "student IS NULL ORDER BY rowid",
                         run);
    std::vector<std::string> notes;
    while (rows->executeStep()) notes.push_back(rows->getColumn(0).getString());
    return notes;
}

std::vector<std::string> notes_of(Connection& db, int run,
                                  const std::string& student) {
    auto rows = prepared(db,
                         "SELECT note FROM run_notes WHERE run = ? AND "
                         "student = ? ORDER BY rowid",
                         run, student);
    std::vector<std::string> notes;
    while (rows->executeStep()) notes.push_back(rows->getColumn(0).getString());
    return notes;
}

std::vector<Suite> suites_of(Connection& db, int run) {
    auto rows = prepared(db,
                         "SELECT exercise, file, version, max FROM run_suites "
                         "WHERE run = ? ORDER BY rowid",
                         run);
    std::vector<Suite> suites;
    while (rows->executeStep())
        suites.push_back(
            {rows->getColumn(0).getString(), rows->getColumn(1).getString(),
             rows->getColumn(2).getString(), rows->getColumn(3).getDouble()});
    return suites;
}

std::vector<Member> members_of(Connection& db, int run,
                               const std::string& student) {
    auto rows = prepared(db,
                         "SELECT name, number, email FROM run_members "
                         "WHERE run = ? AND student = ? ORDER BY rowid",
                         run, student);
    std::vector<Member> members;
    while (rows->executeStep())
        members.push_back({rows->getColumn(0).getString(),
                           rows->getColumn(1).getString(),
                           rows->getColumn(2).getString()});
    return members;
}

Student student_in(Connection& db, int run, SQLite::Statement& row) {
    Student student{
        row.getColumn(0).getString(), row.getColumn(1).getString(), {}};
    student.person = row.getColumn(2).getString();
    student.key = row.getColumn(3).getString();
    student.marked_late = row.getColumn(4).getInt() != 0;
    if (!row.getColumn(5).isNull())
        student.submitted_at = row.getColumn(5).getString();
    student.notes = notes_of(db, run, student.id);
    student.members = members_of(db, run, student.id);
    return student;
}

std::vector<Student> students_of(Connection& db, int run) {
    auto rows = prepared(db,
                         "SELECT student, name, person, key, marked_late, "
                         "submitted_at FROM run_students "
                         "WHERE run = ? ORDER BY rowid",
                         run);
    std::vector<Student> students;
    while (rows->executeStep()) students.push_back(student_in(db, run, *rows));
    return students;
}

// ---- attempts

double earned(const CaseResult& result) {
    return result.verdict == course::Verdict::accepted ? result.info.points
                                                       : 0.0;
}

void insert_case(Connection& db, std::int64_t attempt, int position,
                 const CaseResult& result) {
    const bool shown = result.info.visibility == course::Visibility::shown;
    auto row = prepared(
        db, "INSERT INTO cases VALUES (?,?,?,?,?,?,?,?,?,?)", attempt, position,
        result.info.name, std::string(course::name(result.verdict)),
        earned(result), result.info.points,
        std::string(shown ? "shown" : "hidden"), result.hint, result.printed);
    const std::string blob = course::encode(result.failures);
    row->bind(10, blob.data(), static_cast<int>(blob.size()));
    row->exec();
}

std::int64_t insert_attempt(Connection& db, int run, const Attempt& attempt) {
    const ExerciseResult& result = attempt.result;
    execute(db,
            "INSERT INTO attempts (run, student, exercise, key, verdict, "
            "points, max, message, finished_at, source) VALUES "
            "(?,?,?,?,?,?,?,?,?,?)",
            run, attempt.student, attempt.exercise, attempt.key,
            std::string(course::name(result.verdict)), result.points(),
            result.max(), result.message, attempt.finished_at, attempt.source);
    const std::int64_t row = db.sql.getLastInsertRowid();
    int position = 0;
    for (const CaseResult& one : result.cases)
        insert_case(db, row, position++, one);
    return row;
}

/// The newest row of `counted`, as an attempt; 0 when there is none.
std::int64_t counted_attempt(Connection& db, const std::string& student,
                             const std::string& exercise) {
    auto row = prepared(db,
                        "SELECT attempt FROM counted NATURAL JOIN runs WHERE "
                        "student = ? AND exercise = ? AND NOT proposed "
                        "ORDER BY counted DESC LIMIT 1",
                        student, exercise);
    return row->executeStep() ? row->getColumn(0).getInt64() : 0;
}

void count(Connection& db, int run, const std::string& student,
           const std::string& exercise, std::int64_t attempt) {
    execute(db,
            "INSERT INTO counted (run, student, exercise, attempt) "
            "VALUES (?, ?, ?, ?)",
            run, student, exercise, attempt);
}

std::int64_t attempt_with_key(Connection& db, std::string_view student,
                              std::string_view exercise, std::string_view key) {
    auto row =
        prepared(db,
                 "SELECT attempt FROM attempts WHERE student = ? AND "
                 "exercise = ? AND key = ? AND "
                 "verdict <> 'grader_fault' "
                 "ORDER BY attempt DESC LIMIT 1",
                 std::string(student), std::string(exercise), std::string(key));
    return row->executeStep() ? row->getColumn(0).getInt64() : 0;
}

CaseResult read_case(const std::string& file, SQLite::Statement& row) {
    CaseResult result;
    result.info.name = row.getColumn(0).getString();
    result.verdict = stored_verdict(file, row.getColumn(1).getString());
    result.info.points = row.getColumn(2).getDouble();
    result.info.visibility = row.getColumn(3).getString() == "shown"
                                 ? course::Visibility::shown
                                 : course::Visibility::hidden;
    result.hint = row.getColumn(4).getString();
    result.printed = row.getColumn(5).getString();
    result.failures =
        course::decode<std::vector<Failure>>(row.getColumn(6).getString());
    return result;
}

std::vector<CaseResult> read_cases(const std::string& file, Connection& db,
                                   std::int64_t attempt) {
    auto rows = prepared(db,
                         "SELECT name, verdict, max, visibility, hint, "
                         "printed, failures FROM cases WHERE attempt = ? "
                         "ORDER BY position",
                         attempt);
    std::vector<CaseResult> cases;
    while (rows->executeStep()) cases.push_back(read_case(file, *rows));
    return cases;
}

Attempt read_attempt(const std::string& file, Connection& db,
                     std::int64_t attempt) {
    auto row = prepared(db,
                        "SELECT student, exercise, key, verdict, message, "
                        "finished_at, source FROM attempts WHERE attempt = ?",
                        attempt);
    if (!row->executeStep())
        throw GradebookDamaged(fmt::format(
            "{}: attempt {} counts, but is not there", file, attempt));
    Attempt read;
    read.student = row->getColumn(0).getString();
    read.exercise = row->getColumn(1).getString();
    read.key = row->getColumn(2).getString();
    read.result.verdict = stored_verdict(file, row->getColumn(3).getString());
    read.result.message = row->getColumn(4).getString();
    read.finished_at = row->getColumn(5).getString();
    read.source = row->getColumn(6).getString();
    read.result.cases = read_cases(file, db, attempt);
    return read;
}

}  // namespace

Gradebook::Gradebook(const std::filesystem::path& file, Access access) {
    guarded(file.string(), [&] {
        SQLite::Database sql(file, flags(access), wait_for_lock_ms);
        if (access == Access::write)
            prepare_for_writing(file.string(), sql);
        else
            prepare_for_reading(file.string(), sql);
        database_.reset(
            new Database{file.string(), access, {std::move(sql), {}}});
    });
}

Gradebook::~Gradebook() = default;
Gradebook::Gradebook(Gradebook&&) noexcept = default;
Gradebook& Gradebook::operator=(Gradebook&&) noexcept = default;

int Gradebook::begin_run(const Run& run) {
    return guarded(database_->file, [&] {
        Connection& db = database_->db;
        SQLite::Transaction all(db.sql, SQLite::TransactionBehavior::IMMEDIATE);
        insert_run(db, run);
        const int row = static_cast<int>(db.sql.getLastInsertRowid());
        for (const Suite& suite : run.suites)
            execute(db, "INSERT INTO run_suites VALUES (?, ?, ?, ?, ?)", row,
                    suite.exercise, suite.file, suite.version, suite.max);
        for (const Student& student : run.students)
            insert_student(db, row, student);
        for (const std::string& note : run.notes) insert_note(db, row, note);
        all.commit();
        return row;
    });
}

std::optional<Run> Gradebook::last_run() const {
    return guarded(database_->file, [&]() -> std::optional<Run> {
        Connection& db = database_->db;
        auto row = prepared(db,
                            "SELECT run, started_at, version, sandbox, seed, "
                            "jobs, user, proposed FROM runs WHERE NOT proposed "
                            "ORDER BY run DESC LIMIT 1");
        if (!row->executeStep()) return std::nullopt;
        const int id = row->getColumn(0).getInt();
        Run run = run_facts(database_->file, *row);
        run.suites = suites_of(db, id);
        run.students = students_of(db, id);
        run.notes = notes_of(db, id);
        return run;
    });
}

std::vector<PastRun> Gradebook::runs() const {
    return guarded(database_->file, [&] {
        Connection& db = database_->db;
        auto row = prepared(db,
                            "SELECT run, started_at, version, sandbox, seed, "
                            "jobs, user, proposed FROM runs ORDER BY run");
        std::vector<PastRun> all;
        while (row->executeStep()) {
            const int id = row->getColumn(0).getInt();
            all.push_back({id, run_facts(database_->file, *row)});
            all.back().facts.suites = suites_of(db, id);
        }
        return all;
    });
}

std::vector<Change> Gradebook::changes(int run) const {
    return guarded(database_->file, [&] {
        auto rows = prepared(
            database_->db,
            "SELECT n.student, n.exercise, o.verdict, o.points, n.verdict, "
            "n.points FROM counted JOIN attempts n USING (attempt) "
            "LEFT JOIN standing o ON o.student = n.student AND "
            "o.exercise = n.exercise WHERE counted.run = ? AND "
            "o.attempt IS NOT n.attempt ORDER BY n.student, n.exercise",
            run);
        return changes_in(database_->file, *rows);
    });
}

void Gradebook::accept(int run) {
    guarded(database_->file, [&] {
        execute(database_->db, "UPDATE runs SET proposed = 0 WHERE run = ?",
                run);
    });
}

void Gradebook::record(int run, const Attempt& attempt) {
    guarded(database_->file, [&] {
        Connection& db = database_->db;
        SQLite::Transaction all(db.sql, SQLite::TransactionBehavior::IMMEDIATE);
        const std::int64_t row = insert_attempt(db, run, attempt);
        count(db, run, attempt.student, attempt.exercise, row);
        all.commit();
    });
}

std::optional<ExerciseResult> Gradebook::find(std::string_view student,
                                              std::string_view exercise,
                                              std::string_view key) const {
    return guarded(database_->file, [&]() -> std::optional<ExerciseResult> {
        Connection& db = database_->db;
        const std::int64_t row = attempt_with_key(db, student, exercise, key);
        if (row == 0) return std::nullopt;
        return read_attempt(database_->file, db, row).result;
    });
}

bool Gradebook::reuse(int run, std::string_view student,
                      std::string_view exercise, std::string_view key) {
    return guarded(database_->file, [&] {
        Connection& db = database_->db;
        const std::string s(student), e(exercise);
        const std::int64_t row = attempt_with_key(db, s, e, key);
        if (row == 0 || counted_attempt(db, s, e) == row) return row != 0;
        SQLite::Transaction all(db.sql, SQLite::TransactionBehavior::IMMEDIATE);
        count(db, run, s, e, row);
        all.commit();
        return true;
    });
}

std::optional<Attempt> Gradebook::latest(std::string_view student,
                                         std::string_view exercise) const {
    return guarded(database_->file, [&]() -> std::optional<Attempt> {
        Connection& db = database_->db;
        const std::int64_t row =
            counted_attempt(db, std::string(student), std::string(exercise));
        if (row == 0) return std::nullopt;
        return read_attempt(database_->file, db, row);
    });
}

std::vector<Attempt> Gradebook::latest(std::string_view student) const {
    return guarded(database_->file, [&] {
        Connection& db = database_->db;
        // Beside max(), SQLite gives the other columns of the same row.
        auto rows = prepared(db,
                             "SELECT attempt, max(counted) FROM counted "
                             "NATURAL JOIN runs WHERE student = ? AND NOT "
                             "proposed GROUP BY exercise",
                             std::string(student));
        std::vector<Attempt> attempts;
        while (rows->executeStep())
            attempts.push_back(read_attempt(database_->file, db,
                                            rows->getColumn(0).getInt64()));
        return attempts;
    });
}

}  // namespace grader
