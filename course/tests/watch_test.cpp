// Watch mode as it is built, at a terminal that is not there (a pipe) and at
// one that is (a pseudo terminal): results, keys, and what is left behind.
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "course/cli/progress.h"
#include "course/runner/catch2.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char* good =
    "#include \"exercises/01_traversal/face_sides.h\"\n"
    "int face_sides(const HalfEdgeTable& he, int i) {\n"
    "    if (he[i].fi == -1) return 0;\n"
    "    int n = 0, j = i;\n"
    "    do { ++n; j = he[j].next; } while (j != i);\n"
    "    return n;\n}\n";

/// A student's folder with some exercises as they were handed out.
struct Student {
    TemporaryFolder folder;
    Desk desk{folder.path()};

    Student() {
        for (const char* name : {"face_sides", "face_vertices", "tip"})
            desk.reset(exercise_named(name));
        change_progress(
            desk, [](Progress& progress) { progress.current = "face_sides"; });
    }
    fs::path file(const std::string& name) const {
        return desk.file(exercise_named(name));
    }
};

/// Written beside it and renamed, as many editors do.
void save(const fs::path& file, const std::string& text) {
    const fs::path other = file.string() + "~";
    std::ofstream(other) << text;
    fs::rename(other, file);
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (auto at = text.find(part); at != text.npos;
         at = text.find(part, at + 1))
        ++n;
    return n;
}

/// A running lab, and what it has said so far.
class Lab {
public:
    Lab(const Student& student, int in, int out, const char* terminal) {
        Command command;
        command.arguments = {build_root() / "course" / "lab", "--work",
                             student.folder.path()};
        command.environment = plain_environment();
        command.environment.push_back(std::string("TERM=") + terminal);
        command.environment.push_back("EDITOR=touch");
        command.descriptors = {{in, 0}, {out, 1}, {out, 2}};
        process_.emplace(command);
    }

    /// Reads until it has said this `times` times; false after a long time.
    bool says(int from, const std::string& part, int times = 1) {
        const auto until = Clock::now() + std::chrono::seconds(120);
        while (count(said_, part) < times && Clock::now() < until) {
            pollfd p{from, POLLIN, 0};
            if (::poll(&p, 1, 1000) <= 0) continue;
            char buffer[4096];
            const ssize_t n = ::read(from, buffer, sizeof buffer);
            if (n <= 0) break;
            said_.append(buffer, static_cast<std::size_t>(n));
        }
        return count(said_, part) >= times;
    }

    std::string take() { return std::exchange(said_, ""); }
    const std::string& said() const { return said_; }

    int exit_code() {
        const int status = process_->wait();
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    std::optional<Process> process_;
    std::string said_;
};

/// A pseudo terminal of 80 x 24.
struct PseudoTerminal {
    Descriptor master, slave;

    PseudoTerminal() : master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        REQUIRE(master);
        REQUIRE(::grantpt(master.get()) == 0);
        REQUIRE(::unlockpt(master.get()) == 0);
        slave = Descriptor(
            ::open(::ptsname(master.get()), O_RDWR | O_NOCTTY | O_CLOEXEC));
        REQUIRE(slave);
        const winsize size{24, 80, 0, 0};
        REQUIRE(::ioctl(slave.get(), TIOCSWINSZ, &size) == 0);
    }
    termios settings() const {
        termios now{};
        ::tcgetattr(slave.get(), &now);
        return now;
    }
    void type(const std::string& keys) const {
        REQUIRE(write_all(master.get(), keys.data(), keys.size()));
    }
};

}  // namespace

TEST_CASE("without a terminal each result is printed, until the input ends") {
    const Student student;
    DescriptorPair in = pipe_pair(), out = pipe_pair();
    Lab lab(student, in.first.get(), out.second.get(), "xterm");
    const int from = out.first.get();
    INFO(lab.said());
    REQUIRE(lab.says(from, "face_sides.cpp: wrong answer"));
    CHECK(lab.said().find("Count the sides of a face") != std::string::npos);
    CHECK(lab.said().find('\033') == std::string::npos);
    save(student.file("face_sides"), good);
    REQUIRE(lab.says(from, "face_sides.cpp: accepted"));
    in.second.reset();
    CHECK(lab.exit_code() == 0);
    const Progress progress = read_progress(student.desk);
    CHECK(progress.state(exercise_named("face_sides")) == State::solved);
}

TEST_CASE("of many saves in quick succession the last one counts") {
    const Student student;
    DescriptorPair in = pipe_pair(), out = pipe_pair();
    Lab lab(student, in.first.get(), out.second.get(), "xterm");
    const int from = out.first.get();
    REQUIRE(lab.says(from, "face_sides.cpp: wrong answer"));
    for (int k = 0; k < 100; ++k)
        save(student.file("face_sides"),
             "int broken = " + std::to_string(k) + "\n");
    save(student.file("face_sides"), good);
    REQUIRE(lab.says(from, "face_sides.cpp: accepted"));
    in.second.reset();
    CHECK(lab.exit_code() == 0);
    // On a machine that is not too busy there is none in between.
    CHECK(count(lab.said(), "compile error") < 5);
}

TEST_CASE("an endless loop, a crash and much output leave lab as it is") {
    const Student student;
    DescriptorPair in = pipe_pair(), out = pipe_pair();
    Lab lab(student, in.first.get(), out.second.get(), "xterm");
    const int from = out.first.get();
    REQUIRE(lab.says(from, "wrong answer\n\n"));
    const std::string head =
        "#include \"exercises/01_traversal/face_sides.h\"\n#include <cstdio>\n"
        "#include <cstdlib>\nint face_sides(const HalfEdgeTable& he, int i) {";
    save(student.file("face_sides"), head + "for (;;) i = he[i].next; }");
    REQUIRE(lab.says(from, "time limit exceeded\n\n"));
    save(student.file("face_sides"), head + "std::abort(); return he[i].vi; }");
    REQUIRE(lab.says(from, "run-time error\n\n"));
    save(student.file("face_sides"),
         head + "for (;;) std::puts(\"more\"); return he[i].vi; }");
    REQUIRE(lab.says(from, "Grading runs more cases", 4));
    save(student.file("face_sides"), good);
    REQUIRE(lab.says(from, "accepted\n\n"));
    in.second.reset();
    CHECK(lab.exit_code() == 0);
    CHECK(lab.said().size() < 100'000);
}

TEST_CASE("the keys lead through the screens, and the terminal comes back") {
    const Student student;
    const PseudoTerminal terminal;
    const termios before = terminal.settings();
    Lab lab(student, terminal.slave.get(), terminal.slave.get(), "xterm");
    const int from = terminal.master.get();
    REQUIRE(lab.says(from, "face_sides\033[0m  not accepted"));
    CHECK((terminal.settings().c_lflag & ECHO) == 0);
    terminal.type("h");
    REQUIRE(lab.says(from, "(h: hint 2 of"));
    terminal.type("x");
    REQUIRE(lab.says(from, "Put "));
    lab.take();
    terminal.type("n");
    REQUIRE(lab.says(from, "q quit"));
    terminal.type("l");
    REQUIRE(lab.says(from, "filter: _"));
    terminal.type("where a half-edge\r");
    REQUIRE(lab.says(from, "tip\033[0m  not accepted"));
    CHECK(read_progress(student.desk).current == "tip");
    terminal.type("c");
    REQUIRE(lab.says(from, "not begun."));
    lab.take();
    terminal.type("\033");
    REQUIRE(lab.says(from, "tip\033[0m"));
    terminal.type("q");
    REQUIRE(lab.says(from, "\033[?1049l"));
    CHECK(lab.exit_code() == 1);
    CHECK(terminal.settings().c_lflag == before.c_lflag);
    CHECK(terminal.settings().c_iflag == before.c_iflag);
}

TEST_CASE("reset in watch mode asks, and then checks the original again") {
    const Student student;
    save(student.file("face_sides"), good);
    const PseudoTerminal terminal;
    Lab lab(student, terminal.slave.get(), terminal.slave.get(), "xterm");
    const int from = terminal.master.get();
    REQUIRE(lab.says(from, "face_sides\033[0m  accepted"));
    terminal.type("x");
    REQUIRE(lab.says(from, "Put "));
    terminal.type("y");
    REQUIRE(lab.says(from, "face_sides\033[0m  not accepted"));
    CHECK(student.desk.is_untouched(exercise_named("face_sides")));
    terminal.type("q");
    REQUIRE(lab.says(from, "\033[?1049l"));
    bool is_kept = false;
    for (const auto& entry :
         fs::directory_iterator(student.desk.memory() / "backup"))
        is_kept = is_kept || read_file(entry.path()) == good;
    CHECK(is_kept);
}

TEST_CASE("a current exercise without a file is named, with the way out") {
    const Student student;
    fs::remove(student.file("face_sides"));
    DescriptorPair in = pipe_pair(), out = pipe_pair();
    Lab lab(student, in.first.get(), out.second.get(), "xterm");
    REQUIRE(lab.says(out.first.get(), "reset face_sides"));
    CHECK(lab.exit_code() == 2);
}
