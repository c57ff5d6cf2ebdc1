// The child process that reads hostile bytes: what it cannot do, and what its
// end or its lies do here.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "grader/pipeline/archive.h"
#include "grader/sandbox/confined.h"
#include "grader/tests/archive_maker.h"
#include "grader/tests/class_on_disk.h"

using namespace grader;
using namespace grader::tests;

namespace {

struct Said {
    std::string bytes;
    std::string failure;
};

/// What the work wrote into its pipe, and how it ended.
Said confined(const std::function<void(int)>& work,
              const ConfinedLimits& limits = {}) {
    Confined child(limits, {}, work);
    Said said;
    char c = 0;
    while (course::read_all(child.out(), &c, 1)) said.bytes += c;
    said.failure = child.how_it_failed();
    return said;
}

/// Whether the work, which says "yes" or "no", could do it.
std::string can(const std::function<bool()>& work) {
    const Said said = confined([&](int out) {
        const std::string answer = work() ? "yes" : "no";
        course::write_all(out, answer.data(), answer.size());
    });
    return said.bytes + said.failure;
}

course::Descriptor memory_file(const std::string& bytes) {
    course::Descriptor file = course::anonymous_file();
    REQUIRE(course::write_all(file.get(), bytes.data(), bytes.size()));
    return file;
}

const MostBytes everything = [](std::string_view) {
    return std::optional<std::size_t>(1000);
};

/// The message of the error that reading a good archive ends in, where
/// `most_bytes` says something else in the child.
std::string error_of(const MostBytes& in_child, const MostBytes& here) {
    const course::Descriptor file =
        memory_file(packed(zip, {{"prev.cpp"}, {"face_sides.cpp"}}));
    const pid_t self = ::getpid();
    try {
        read_archive_confined(
            file.get(), ArchiveFormat::zip, {}, 2,
            [&](std::string_view path) {
                return ::getpid() == self ? here(path) : in_child(path);
            },
            [](const ArchiveEntry&) {});
    } catch (const ArchiveError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("work that comes to its end says what it has to say") {
    CHECK(can([] { return true; }) == "yes");
}

TEST_CASE("a confined process opens no file, not even for reading") {
    CHECK(can([] { return ::open("/etc/passwd", O_RDONLY) >= 0; }) == "no");
    CHECK(can([] { return ::open("/proc/self/mem", O_RDONLY) >= 0; }) == "no");
    CHECK(can([] { return ::dup(1) >= 0; }) == "no");
}

TEST_CASE("a confined process cannot give itself descriptors again") {
    CHECK(can([] {
              const rlimit more{100, 100};
              return ::setrlimit(RLIMIT_NOFILE, &more) == 0;
          }) == "no");
}

TEST_CASE("a confined process that writes, connects or starts is ended") {
    const std::string killed = "its process was ended by signal 31";
    CHECK_THAT(can([] { return ::open("/tmp/x", O_CREAT | O_RDWR, 0600) < 0; }),
               Containing(killed));
    CHECK_THAT(can([] { return ::socket(AF_INET, SOCK_STREAM, 0) < 0; }),
               Containing(killed));
    CHECK_THAT(can([] { return ::fork() < 0; }), Containing(killed));
    CHECK_THAT(can([] { return ::execl("/bin/true", "true", nullptr) < 0; }),
               Containing(killed));
    CHECK_THAT(can([] { return ::kill(::getppid(), SIGTERM) == 0; }),
               Containing(killed));
    CHECK_THAT(can([] { return ::unlink("/tmp/nothing") == 0; }),
               Containing(killed));
}

TEST_CASE("a confined process has no descriptor but those that it was given") {
    const course::Descriptor secret = memory_file("secret");
    const int number = secret.get();
    CHECK(can([number] { return ::lseek(number, 0, SEEK_SET) == 0; }) == "no");
    CHECK(can([] { return ::write(2, "x", 1) == 1; }) == "no");
}

TEST_CASE("the end of a confined process is told") {
    CHECK_THAT(confined([](int) { ::raise(SIGSEGV); }).failure,
               Containing("signal 11"));
    CHECK_THAT(confined([](int) { std::abort(); }).failure,
               Containing("signal 6"));
    CHECK(confined([](int) { throw 1; }).failure == "its process failed");
    CHECK(confined([](int) {
              const std::vector<char> much(std::size_t{2} << 30);
              if (much[much.size() / 2] != 0) throw 1;
          }).failure == "its process ran out of memory");
    ConfinedLimits limits;
    limits.cpu_seconds = 1;
    const auto forever = [](int) {
        for (volatile unsigned k = 0;;) k = k + 1;
    };
    CHECK(confined(forever, limits).failure ==
          "its process used more time than it may");
}

TEST_CASE("a confined process that closes its pipe and stays is ended") {
    const Said said = confined([](int out) {
        ::close(out);
        ::sleep(1000);
    });
    CHECK_THAT(said.failure, Containing("signal 9"));
}

TEST_CASE("an archive whose reader crashes is one that cannot be read") {
    const auto crash = [](std::string_view) -> std::optional<std::size_t> {
        std::abort();
    };
    CHECK_THAT(error_of(crash, everything),
               Containing("could not be read (its process was ended by signal "
                          "6"));
    CHECK(error_of(everything, everything).empty());
}

TEST_CASE("an archive whose reader takes too much time or memory") {
    const auto hang = [](std::string_view) -> std::optional<std::size_t> {
        for (volatile unsigned k = 0;;) k = k + 1;
    };
    CHECK(error_of(hang, everything) ==
          "could not be read (its process used more time than it may)");
    const auto eat = [](std::string_view path) -> std::optional<std::size_t> {
        const std::vector<char> much(std::size_t{2} << 30);
        return much.size() + path.size();
    };
    CHECK(error_of(eat, everything) ==
          "could not be read (its process ran out of memory)");
}

TEST_CASE("a reader that sends what was not asked for is not believed") {
    const std::string lied =
        "could not be read (its process said what cannot be)";
    const auto nothing = [](std::string_view) -> std::optional<std::size_t> {
        return std::nullopt;
    };
    const auto little_only = [](std::string_view) {
        return std::optional<std::size_t>(1);
    };
    CHECK(error_of(everything, nothing) == lied);
    CHECK(error_of(nothing, everything) == lied);
    CHECK(error_of(everything, little_only) == lied);
}

TEST_CASE("read in this process an archive says the same as in the child") {
    const course::Descriptor file = memory_file(
        tar_of({{"prev.cpp"}, {"../x"}, {"a/", '5', ""}, {"b", '2', "", "/"}}));
    std::vector<std::string> here, there;
    const auto into = [](std::vector<std::string>& to) {
        return [&to](const ArchiveEntry& e) {
            to.push_back(std::to_string(e.index) + " " + e.path + " " +
                         e.refusal + " " + e.bytes.value_or("none"));
        };
    };
    read_archive(file.get(), ArchiveFormat::tar, {}, everything, into(here));
    read_archive_confined(file.get(), ArchiveFormat::tar, {}, 2, everything,
                          into(there));
    CHECK(here == there);
    CHECK(here == std::vector<std::string>{
                      "1 prev.cpp  int x;",
                      "2 ../x leads out of its folder by \"..\" none",
                      "3 a  none", "4 b is a symbolic link none"});
}
