// What runs know of mistakes.
#include "grader/gradebook/database.h"

namespace grader {

std::set<std::pair<std::string, course::Verdict>> Gradebook::partly_failed(
    int run) const {
    return guarded(database_->file, [&] {
        auto rows = prepared(
            database_->db,
            "SELECT DISTINCT exercise, verdict FROM attempts a WHERE attempt "
            "IN (SELECT attempt FROM standing UNION SELECT attempt FROM "
            "counted WHERE run = ?) AND verdict <> 'accepted' "
            "AND points > 0",
            run);
        std::set<std::pair<std::string, course::Verdict>> all;
        while (rows->executeStep())
            all.emplace(rows->getColumn(0).getString(),
                        stored_verdict(database_->file,
                                       rows->getColumn(1).getString()));
        return all;
    });
}

void Gradebook::add_mistakes(int run, const std::vector<KnownMistake>& known) {
    guarded(database_->file, [&] {
        Connection& db = database_->db;
        SQLite::Transaction all(db.sql, SQLite::TransactionBehavior::IMMEDIATE);
        for (const KnownMistake& one : known)
            execute(db, "INSERT INTO run_mistakes VALUES (?, ?, ?, ?, ?, ?)",
                    run, one.exercise, one.name, one.mistake, one.hint,
                    one.fingerprint);
        all.commit();
    });
}

std::vector<KnownMistake> Gradebook::mistakes() const {
    return guarded(database_->file, [&] {
        auto rows =
            prepared(database_->db,
                     "SELECT exercise, name, mistake, hint, fingerprint FROM "
                     "run_mistakes WHERE run = (SELECT max(run) FROM runs "
                     "WHERE NOT proposed) ORDER BY rowid");
        std::vector<KnownMistake> known;
        while (rows->executeStep())
            known.push_back(
                {rows->getColumn(0).getString(), rows->getColumn(1).getString(),
                 rows->getColumn(2).getString(), rows->getColumn(3).getString(),
                 rows->getColumn(4).getString()});
        return known;
    });
}

}  // namespace grader
