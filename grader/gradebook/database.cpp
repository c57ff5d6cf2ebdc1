#include "grader/gradebook/database.h"

namespace grader {

void translate(const std::string& file, const SQLite::Exception& error) {
    const std::string why = error.what();
    switch (error.getErrorCode()) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw GradebookLocked(fmt::format(
                "{}: another process has held it for {} s; expected it to be "
                "free: is another run, or a database browser, using it?",
                file, wait_for_lock_ms / 1000));
        case SQLITE_READONLY:
        case SQLITE_PERM:
            throw GradebookReadOnly(fmt::format(
                "{}: cannot be written ({}); expected a file and a folder "
                "that may be written",
                file, why));
        case SQLITE_NOTADB:
            throw GradebookForeign(fmt::format(
                "{}: is not a SQLite file; expected a gradebook", file));
        case SQLITE_CANTOPEN:
            throw GradebookMissing(fmt::format(
                "{}: cannot be opened or created ({}); expected a file in a "
                "folder that exists",
                file, why));
        case SQLITE_FULL:
            throw GradebookFull(
                fmt::format("{}: the disk is full; nothing was half written, "
                            "expected room for the result",
                            file));
        case SQLITE_CORRUPT:
            throw GradebookDamaged(fmt::format(
                "{}: is damaged ({}); expected a whole gradebook", file, why));
        default:
            throw GradebookError(fmt::format("{}: {}", file, why));
    }
}

course::Verdict stored_verdict(const std::string& file,
                               const std::string& name) {
    if (const auto verdict = course::verdict_named(name)) return *verdict;
    throw GradebookDamaged(
        fmt::format("{}: a stored verdict is '{}'; expected one such as "
                    "'accepted'",
                    file, name));
}

std::vector<Change> changes_in(const std::string& file,
                               SQLite::Statement& rows) {
    std::vector<Change> all;
    while (rows.executeStep()) {
        Change one;
        one.student = rows.getColumn(0).getString();
        one.exercise = rows.getColumn(1).getString();
        if (!rows.getColumn(2).isNull())
            one.old_verdict =
                stored_verdict(file, rows.getColumn(2).getString());
        one.old_points = rows.getColumn(3).getDouble();
        one.verdict = stored_verdict(file, rows.getColumn(4).getString());
        one.points = rows.getColumn(5).getDouble();
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace grader
