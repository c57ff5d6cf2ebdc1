// The gradebook gives back what was written, and keeps all of it.
#include <SQLiteCpp/SQLiteCpp.h>

#include "course/runner/codec.h"
#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

constexpr const char* exercise = "01_traversal/face_sides";

Attempt attempt(std::string key, ExerciseResult result) {
    return {"carla", exercise, std::move(key), std::move(result),
            "2024-03-01T09:31:00Z"};
}

std::string bytes(const ExerciseResult& result) {
    return course::encode(result);
}

std::string bytes(const std::optional<ExerciseResult>& result) {
    REQUIRE(result.has_value());
    return course::encode(*result);
}

int count(const std::filesystem::path& file, const std::string& sql) {
    const SQLite::Database other(file);
    SQLite::Statement query(other, sql);
    REQUIRE(query.executeStep());
    return query.getColumn(0).getInt();
}

}  // namespace

TEST_CASE("every result comes back as it was recorded, after reopening") {
    const course::TemporaryFolder folder;
    const ClassResults sample = sample_class();
    {
        Gradebook book(folder / "g.sqlite");
        const int run = book.begin_run(sample.run);
        for (const StudentResults& student : sample.students)
            for (std::size_t k = 0; k < 3; ++k)
                book.record(run,
                            {student.student.id, sample.exercises[k].exercise,
                             "key", *student.exercises[k], "now"});
    }
    const Gradebook book(folder / "g.sqlite", Gradebook::Access::read);
    CHECK((book.last_run() == sample.run));
    for (const StudentResults& student : sample.students)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto latest =
                book.latest(student.student.id, sample.exercises[k].exercise);
            REQUIRE(latest.has_value());
            CHECK((bytes(latest->result) == bytes(student.exercises[k])));
            CHECK(latest->key == "key");
            CHECK(latest->finished_at == "now");
        }
}

TEST_CASE("texts with null bytes and without UTF-8 come back as they were") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    ExerciseResult strange = result(
        Verdict::wrong_answer,
        cases(Verdict::wrong_answer, Verdict::accepted, Verdict::accepted));
    strange.message = std::string("a\0b\xff'; DROP TABLE runs; --", 26);
    strange.cases[0].printed = std::string(1'000'000, '\xfe');
    strange.cases[0].failures = {off_the_table(), Failure()};
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("k", strange));
    CHECK((bytes(book.find("carla", exercise, "k")) == bytes(strange)));
}

TEST_CASE("nothing is overwritten, and the newest attempt counts") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("first", *all_accepted()[0]));
    book.record(run, attempt("second", *wrong_and_endless()[0]));
    CHECK(book.latest("carla", exercise)->key == "second");
    CHECK((bytes(book.find("carla", exercise, "first")) ==
           bytes(all_accepted()[0])));
    CHECK(count(folder / "g.sqlite", "SELECT count(*) FROM attempts") == 2);
    CHECK_FALSE(book.latest("anna.rossi", exercise).has_value());
    CHECK_FALSE(book.find("carla", exercise, "third").has_value());
    CHECK_FALSE(book.find("carla", "other", "first").has_value());
}

TEST_CASE("a clock that goes back does not bring an old result back") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    Attempt first = attempt("first", *sample_class().students[0].exercises[0]);
    Attempt second = attempt("second", first.result);
    first.finished_at = "2031-01-01T00:00:00Z";
    second.finished_at = "1970-01-01T00:00:00Z";
    book.record(run, first);
    book.record(run, second);
    CHECK(book.latest("carla", exercise)->key == "second");
}

TEST_CASE("what counts for a student comes all at once") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    const std::string later = "02_border/boundary_walk";
    book.record(run, {"carla", later, "none", *nothing()[0], "now"});
    book.record(run, {"carla", later, "a", *all_accepted()[1], "now"});
    book.record(run, attempt("first", *all_accepted()[0]));
    book.record(run, attempt("second", *wrong_and_endless()[0]));
    book.record(run, {"anna.rossi", later, "b", *all_accepted()[0], "now"});
    book.reuse(run, "carla", exercise, "first");
    const std::vector<Attempt> latest = book.latest("carla");
    REQUIRE(latest.size() == 2);
    CHECK(latest[0].exercise == exercise);
    CHECK(latest[0].key == "first");
    CHECK((bytes(latest[0].result) == bytes(all_accepted()[0])));
    CHECK(latest[1].exercise == later);
    CHECK(latest[1].key == "a");
    CHECK(book.latest("nobody").empty());
}

TEST_CASE("a student who goes back to an earlier version gets its points") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("first", *all_accepted()[0]));
    book.record(run, attempt("second", *wrong_and_endless()[0]));
    const int later = book.begin_run(sample_run());
    CHECK(book.reuse(later, "carla", exercise, "first"));
    CHECK(book.latest("carla", exercise)->key == "first");
    // Nothing changes when what counts is used once more.
    const std::string rows = "SELECT count(*) FROM counted";
    CHECK(count(folder / "g.sqlite", rows) == 3);
    CHECK(book.reuse(later, "carla", exercise, "first"));
    CHECK(count(folder / "g.sqlite", rows) == 3);
    CHECK_FALSE(book.reuse(later, "carla", exercise, "third"));
    CHECK(book.latest("carla", exercise)->key == "first");
}

TEST_CASE("a grader fault counts until it is retried, but is never reused") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("k", result(Verdict::grader_fault, {}, "why")));
    CHECK(book.latest("carla", exercise)->result.message == "why");
    CHECK_FALSE(book.find("carla", exercise, "k").has_value());
    CHECK_FALSE(book.reuse(run, "carla", exercise, "k"));
    book.record(run, attempt("k", *all_accepted()[0]));
    CHECK(book.find("carla", exercise, "k").has_value());
}

TEST_CASE("what a proposed run reached counts when it is accepted") {
    const course::TemporaryFolder folder;
    const std::filesystem::path file = folder / "g.sqlite";
    Gradebook book(file);
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("old", *all_accepted()[0]));
    Run proposal = sample_run();
    proposal.seed = 77;
    proposal.proposed = true;
    const int proposed = book.begin_run(proposal);
    book.record(proposed, attempt("new", *wrong_and_endless()[0]));

    CHECK(book.last_run()->seed != 77);
    CHECK(book.latest("carla", exercise)->key == "old");
    CHECK(book.latest("carla").at(0).key == "old");
    CHECK(count(file, "SELECT count(*) FROM standing") == 1);
    const std::vector<Change> changes = book.changes(proposed);
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].student == "carla");
    CHECK(changes[0].exercise == exercise);
    CHECK(changes[0].old_verdict == Verdict::accepted);
    CHECK(changes[0].old_points == all_accepted()[0]->points());
    CHECK(changes[0].verdict == wrong_and_endless()[0]->verdict);
    CHECK(changes[0].points == wrong_and_endless()[0]->points());

    book.accept(proposed);
    CHECK(book.last_run()->seed == 77);
    CHECK(book.latest("carla", exercise)->key == "new");
    CHECK(book.changes(proposed).empty());
    CHECK(count(file, "SELECT count(*) FROM attempts") == 2);
}

TEST_CASE(
    "what was proposed and not taken is found again, and only counts then") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("old", *all_accepted()[0]));
    Run proposal = sample_run();
    proposal.proposed = true;
    book.record(book.begin_run(proposal),
                attempt("new", *wrong_and_endless()[0]));
    const int again = book.begin_run(proposal);
    CHECK(book.reuse(again, "carla", exercise, "new"));
    CHECK(book.changes(again).size() == 1);
    CHECK(book.latest("carla", exercise)->key == "old");
    book.accept(again);
    CHECK(book.latest("carla", exercise)->key == "new");
}

TEST_CASE("a first result is a change, and one that counts already is none") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    Run proposal = sample_run();
    proposal.proposed = true;
    const int proposed = book.begin_run(proposal);
    book.record(proposed, attempt("k", *all_accepted()[0]));
    REQUIRE(book.changes(proposed).size() == 1);
    CHECK_FALSE(book.changes(proposed)[0].old_verdict.has_value());
    book.accept(proposed);
    const int again = book.begin_run(proposal);
    CHECK(book.reuse(again, "carla", exercise, "k"));
    CHECK(book.changes(again).empty());
}

TEST_CASE("an attempt needs a run") {
    const course::TemporaryFolder folder;
    Gradebook book(folder / "g.sqlite");
    CHECK_FALSE(book.last_run().has_value());
    CHECK_THROWS_AS(book.record(7, attempt("k", *all_accepted()[0])),
                    GradebookError);
    CHECK(count(folder / "g.sqlite", "SELECT count(*) FROM cases") == 0);
}

TEST_CASE("an instructor can ask in plain SQL") {
    const course::TemporaryFolder folder;
    const std::filesystem::path file = folder / "g.sqlite";
    Gradebook book(file);
    const int run = book.begin_run(sample_run());
    book.record(run, attempt("a", *all_accepted()[0]));
    book.record(run, attempt("b", *wrong_and_endless()[0]));
    CHECK(count(file,
                "SELECT points FROM standing WHERE student = 'carla' "
                "AND verdict = 'wrong_answer'") == 5);
    CHECK(count(file, "SELECT count(*) FROM standing") == 1);
    CHECK(count(file,
                "SELECT count(*) FROM cases WHERE visibility = 'hidden' "
                "AND verdict = 'wrong_answer' AND points = 0 "
                "AND max = 3") == 1);
    CHECK(count(file,
                "SELECT count(*) FROM runs WHERE "
                "seed = '18446744073709551615'") == 1);
    CHECK(count(file,
                "SELECT count(*) FROM run_notes "
                "WHERE student IS NULL") == 1);
    CHECK(count(file, "SELECT count(*) FROM run_students") == 5);
}

// Gradebooks that are kept for years hold these bytes: when this fails, the
// structs of results.h have changed, and schema_version must change with them.
TEST_CASE("stored failures have the bytes of schema version 1") {
    check_golden("failures.blob",
                 course::encode(std::vector{wrong_count(), off_the_table()}));
}
