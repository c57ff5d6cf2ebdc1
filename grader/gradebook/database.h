// What the parts of the gradebook have in common: an open database, and how its
// errors become ours.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "course/runner/codec.h"
#include "grader/gradebook/gradebook.h"

namespace grader {

inline constexpr int wait_for_lock_ms = 3000;

/// Throws the GradebookError that stands for what SQLite says.
[[noreturn]] void translate(const std::string& file,
                            const SQLite::Exception& error);

/// Runs `work`, and turns what SQLite and the codec throw into our own types.
template <class Work>
auto guarded(const std::string& file, Work work) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        translate(file, error);
    } catch (const course::CodecError& error) {
        throw GradebookDamaged(fmt::format(
            "{}: a stored failure cannot be read: {}", file, error.what()));
    }
}

/// A database with the statements that were asked of it so far: to compile one
/// takes far longer than to run it.
struct Connection {
    SQLite::Database sql;
    std::map<std::string_view, SQLite::Statement> statements;
};

/// A statement with its values. When it goes, the statement is free for the
/// next values, and nothing is held locked by it.
struct Reset {
    void operator()(SQLite::Statement* statement) const {
        statement->tryReset();
    }
};
using Query = std::unique_ptr<SQLite::Statement, Reset>;

/// Precondition: `text` is a literal, and no query of this text is in use.
template <class... Values>
Query prepared(Connection& db, const char* text, const Values&... values) {
    const auto kept = db.statements.try_emplace(text, db.sql, text).first;
    Query query(&kept->second);
    int position = 0;
    (query->bind(++position, values), ...);
    return query;
}

template <class... Values>
void execute(Connection& db, const char* text, const Values&... values) {
    prepared(db, text, values...)->exec();
}

/// The verdict of that name. Throws GradebookDamaged.
course::Verdict stored_verdict(const std::string& file,
                               const std::string& name);

/// The rows of a query for student, exercise, old verdict and points, new
/// verdict and points.
std::vector<Change> changes_in(const std::string& file,
                               SQLite::Statement& rows);

struct Gradebook::Database {
    std::string file;
    Access access;
    Connection db;

    ~Database() {
        if (access == Access::read) return;
        // Fails while another process uses the file: the last one does it.
        sqlite3_busy_timeout(db.sql.getHandle(), 0);
        db.sql.tryExec("PRAGMA journal_mode = DELETE");
    }
};

}  // namespace grader
