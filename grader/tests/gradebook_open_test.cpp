// Files that cannot serve as a gradebook are refused, each with its reason,
// and stay as they are.
#include <SQLiteCpp/SQLiteCpp.h>
#include <unistd.h>

#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

void execute(const std::filesystem::path& file, const std::string& sql) {
    SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec(sql);
}

/// What that version had, and nothing else.
void make_older(const std::filesystem::path& file, int version) {
    execute(file, "DROP VIEW standing");
    execute(file, "DROP TABLE set_by_hand");
    execute(file, "DROP TABLE run_members");
    for (const char* column : {"person", "key", "submitted_at", "marked_late"})
        execute(file,
                std::string("ALTER TABLE run_students DROP COLUMN ") + column);
    execute(file, "DROP TABLE run_mistakes");
    execute(file, "ALTER TABLE attempts DROP COLUMN source");
    execute(file, "ALTER TABLE runs DROP COLUMN user");
    if (version == 1) execute(file, "ALTER TABLE runs DROP COLUMN proposed");
    execute(file, "CREATE VIEW standing AS SELECT * FROM attempts");
    execute(file, "PRAGMA user_version = " + std::to_string(version));
}

std::string message(const std::filesystem::path& file,
                    Gradebook::Access access = Gradebook::Access::write) {
    try {
        const Gradebook book(file, access);
    } catch (const GradebookError& error) {
        return error.what();
    }
    return "opened";
}

/// Access checks do not hold for root: become nobody for a while.
class AsNobody {
public:
    AsNobody() : was_(geteuid()) {
        if (was_ == 0) REQUIRE(seteuid(65534) == 0);
    }
    ~AsNobody() {
        if (was_ == 0 && seteuid(was_) != 0) std::abort();
    }

private:
    uid_t was_;
};

}  // namespace

TEST_CASE("a gradebook is made where there is none, and in an empty file") {
    const course::TemporaryFolder folder;
    CHECK(message(folder / "new.sqlite") == "opened");
    write(folder / "empty.sqlite", "");
    CHECK(message(folder / "empty.sqlite") == "opened");
    CHECK(message(folder / "empty.sqlite") == "opened");
}

TEST_CASE("a gradebook at rest is one file that can be copied") {
    const course::TemporaryFolder folder;
    {
        Gradebook book(folder / "g.sqlite");
        book.begin_run(sample_run());
    }
    std::filesystem::copy(folder / "g.sqlite", folder / "copy.sqlite");
    const Gradebook copy(folder / "copy.sqlite", Gradebook::Access::read);
    CHECK((copy.last_run() == sample_run()));
    for (const auto& one : std::filesystem::directory_iterator(folder.path()))
        CHECK(one.path().extension() == ".sqlite");
}

TEST_CASE("what is not a gradebook is refused and not touched") {
    const course::TemporaryFolder folder;
    const auto text = folder / "notes.txt";
    write(text, "dear diary, this is not a database at all\n");
    CHECK_THROWS_AS(Gradebook(text), GradebookForeign);
    CHECK_THAT(message(text), Containing("notes.txt: is not a SQLite file; "
                                         "expected a gradebook"));
    CHECK(file_contents(text) == "dear diary, this is not a database at all\n");

    const auto other = folder / "other.sqlite";
    execute(other, "PRAGMA journal_mode = WAL; CREATE TABLE t (x)");
    const std::string before = file_contents(other);
    CHECK_THROWS_AS(Gradebook(other), GradebookForeign);
    CHECK_THAT(message(other), Containing("its application id is 0; expected"));
    CHECK((file_contents(other) == before));
}

TEST_CASE("a gradebook of a newer grader is refused and not touched") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    CHECK(message(file) == "opened");
    execute(file, "PRAGMA user_version = 4");
    CHECK_THROWS_AS(Gradebook(file), GradebookNewer);
    CHECK_THAT(message(file), Containing("has schema 4; expected at most 3"));
}

TEST_CASE("an older gradebook is brought up to date when it is opened") {
    const course::TemporaryFolder folder;
    const std::filesystem::path file = folder / "g.sqlite";
    for (const int version : {1, 2})
        for (const auto access :
             {Gradebook::Access::write, Gradebook::Access::read}) {
            std::filesystem::remove(file);
            {
                Gradebook made(file);
                const int run = made.begin_run(sample_run());
                made.record(run,
                            {"carla", "e", "k", *all_accepted()[0], "now"});
            }
            make_older(file, version);
            const Gradebook book(file, access);
            REQUIRE(book.last_run().has_value());
            CHECK((book.last_run() == sample_run()));
            CHECK(book.latest("carla").size() == 1);
            CHECK(book.history("carla").size() == 1);
            CHECK(book.set_by_hand("carla").empty());
        }
}

TEST_CASE("a missing file or folder is named") {
    const course::TemporaryFolder folder;
    CHECK_THROWS_AS(Gradebook(folder / "no/g.sqlite"), GradebookMissing);
    CHECK_THROWS_AS(Gradebook(folder.path()), GradebookMissing);
    const auto file = folder / "g.sqlite";
    CHECK_THROWS_AS(Gradebook(file, Gradebook::Access::read), GradebookMissing);
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("a gradebook that another process holds is refused after a while") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    CHECK(message(file) == "opened");
    SQLite::Database other(file, SQLite::OPEN_READWRITE);
    other.exec("BEGIN EXCLUSIVE");
    CHECK_THROWS_AS(Gradebook(file), GradebookLocked);
    CHECK_THAT(message(file),
               Containing("another process has held it for 3 s"));
    other.exec("COMMIT");
    CHECK(message(file) == "opened");
}

TEST_CASE("a read-only gradebook can be read but not written") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    Gradebook(file).begin_run(sample_run());
    using std::filesystem::perms;
    std::filesystem::permissions(file, perms(0444));
    std::filesystem::permissions(folder.path(), perms(0555));
    {
        const AsNobody nobody;
        CHECK_THROWS_AS(Gradebook(file), GradebookReadOnly);
        CHECK_THAT(message(file), Containing("may only be read"));
        const Gradebook book(file, Gradebook::Access::read);
        CHECK((book.last_run() == sample_run()));
    }
    std::filesystem::permissions(folder.path(), perms(0755));
}

TEST_CASE("a folder that may not be written is found out when opening") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    CHECK(message(file) == "opened");
    using std::filesystem::perms;
    std::filesystem::permissions(file, perms(0666));
    std::filesystem::permissions(folder.path(), perms(0555));
    {
        const AsNobody nobody;
        CHECK_THROWS_AS(Gradebook(file), GradebookReadOnly);
        CHECK_THAT(message(file), Containing("a folder that may be written"));
    }
    std::filesystem::permissions(folder.path(), perms(0755));
}

TEST_CASE("a damaged gradebook is reported, not repaired") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    {
        Gradebook book(file);
        const int run = book.begin_run(sample_run());
        book.record(run, {"carla", "e", "k", *wrong_and_endless()[0], "now"});
    }
    SECTION("a stored failure is cut short") {
        execute(file, "UPDATE cases SET failures = x'0100'");
        const Gradebook book(file);
        CHECK_THROWS_AS(book.latest("carla", "e"), GradebookDamaged);
    }
    SECTION("a verdict that does not exist") {
        execute(file, "UPDATE cases SET verdict = 'perfect'");
        const Gradebook book(file);
        CHECK_THROWS_AS(book.latest("carla", "e"), GradebookDamaged);
    }
    SECTION("an attempt that counts is not there") {
        execute(file, "DELETE FROM attempts");
        const Gradebook book(file);
        CHECK_THROWS_AS(book.latest("carla"), GradebookDamaged);
    }
    SECTION("a seed that is no number") {
        execute(file, "UPDATE runs SET seed = '12x'");
        const Gradebook book(file);
        CHECK_THROWS_AS(book.last_run(), GradebookDamaged);
    }
    SECTION("a visibility that does not exist stays hidden") {
        execute(file, "UPDATE cases SET visibility = 'maybe'");
        const Gradebook book(file);
        const auto latest = book.latest("carla", "e");
        for (const CaseResult& one : latest->result.cases)
            CHECK((one.info.visibility == Visibility::hidden));
    }
    SECTION("half of the file is missing") {
        std::filesystem::resize_file(file,
                                     std::filesystem::file_size(file) / 2);
        CHECK_THROWS_AS(Gradebook(file).last_run(), GradebookDamaged);
    }
}
