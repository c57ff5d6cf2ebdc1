// A run that is killed at any moment, and several runs at once, leave whole
// results and nothing else.
#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "course/runner/codec.h"
#include "course/runner/temporary_folder.h"
#include "grader/gradebook/gradebook.h"
#include "grader/tests/golden.h"
#include "grader/tests/sample_results.h"

using namespace grader;
using namespace grader::tests;

namespace {

std::string key(int writer, int n) {
    return std::to_string(writer) + "." + std::to_string(n);
}

/// Records `attempts` results; after each, a byte goes to `told`.
[[noreturn]] void write_results(const std::filesystem::path& file, int writer,
                                int attempts, int told) {
    try {
        Gradebook book(file);
        const int run = book.begin_run(sample_run());
        for (int n = 0; n < attempts; ++n) {
            book.record(run, {"carla", "e", key(writer, n),
                              *wrong_and_endless()[0], "now"});
            if (write(told, "x", 1) != 1) _exit(2);
        }
    } catch (const std::exception&) {
        _exit(1);
    }
    _exit(0);
}

struct Writer {
    pid_t process;
    int told;
};

Writer start(const std::filesystem::path& file, int writer, int attempts) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t process = fork();
    REQUIRE(process >= 0);
    if (process == 0) write_results(file, writer, attempts, ends[1]);
    close(ends[1]);
    return {process, ends[0]};
}

/// How many results the writer says are recorded.
int recorded(const Writer& writer) {
    int count = 0;
    char byte = 0;
    while (read(writer.told, &byte, 1) == 1) ++count;
    close(writer.told);
    return count;
}

int exit_status(const Writer& writer) {
    int status = 0;
    REQUIRE(waitpid(writer.process, &status, 0) == writer.process);
    return status;
}

void check_whole(const Gradebook& book, int writer, int attempts) {
    const std::string expected = course::encode(*wrong_and_endless()[0]);
    for (int n = 0; n < attempts; ++n) {
        const auto found = book.find("carla", "e", key(writer, n));
        REQUIRE(found.has_value());
        REQUIRE((course::encode(*found) == expected));
    }
}

}  // namespace

TEST_CASE("a killed run loses nothing that was recorded and half of nothing") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    int all = 0;
    for (int writer = 0; writer < 25; ++writer) {
        const Writer child = start(file, writer, 1'000'000);
        // The first ones die while they make the file.
        usleep(static_cast<useconds_t>(writer * writer * 350));
        REQUIRE(kill(child.process, SIGKILL) == 0);
        const int done = recorded(child);
        REQUIRE(WIFSIGNALED(exit_status(child)));
        const Gradebook book(file);
        check_whole(book, writer, done);
        // One more may have been recorded and not yet told: whole or not at
        // all.
        if (book.find("carla", "e", key(writer, done)))
            check_whole(book, writer, done + 1);
        CHECK_FALSE(book.find("carla", "e", key(writer, done + 1)));
        all += done;
    }
    CHECK(all > 0);
    const SQLite::Database sql(file);
    CHECK(SQLite::Statement(sql, "PRAGMA foreign_key_check").executeStep() ==
          false);
    SQLite::Statement whole(sql, "PRAGMA integrity_check");
    REQUIRE(whole.executeStep());
    CHECK(whole.getColumn(0).getString() == "ok");
}

TEST_CASE("several processes can record into one gradebook at once") {
    const course::TemporaryFolder folder;
    const auto file = folder / "g.sqlite";
    constexpr int writers = 4, attempts = 20;
    std::vector<Writer> children;
    for (int writer = 0; writer < writers; ++writer)
        children.push_back(start(file, writer, attempts));
    for (const Writer& child : children) {
        CHECK(recorded(child) == attempts);
        CHECK(exit_status(child) == 0);
    }
    const Gradebook book(file);
    for (int writer = 0; writer < writers; ++writer)
        check_whole(book, writer, attempts);
}
