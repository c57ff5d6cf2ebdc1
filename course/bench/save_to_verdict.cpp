// How long a student waits: from the save to the verdict of `lab` in watch
// mode, beside the compiler alone on the same file. Alternating, medians.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "course/cli/progress.h"
#include "course/runner/compile.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

namespace course {

namespace {

namespace fs = std::filesystem;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr int saves = 20;
constexpr double most_ratio = 1.3;

/// A right solution; `turn` makes each text another one.
std::string solution(int turn) {
    return fmt::format(
        "#include \"exercises/01_traversal/face_sides.h\"\n"
        "// {}\n"
        "int face_sides(const HalfEdgeTable& he, int i) {{\n"
        "    if (he[i].fi == -1) return 0;\n"
        "    int n = 0, j = i;\n"
        "    do {{ ++n; j = he[j].next; }} while (j != i);\n"
        "    return n;\n}}\n",
        turn);
}

/// lab in watch mode, read through a pipe.
class WatchingLab {
public:
    explicit WatchingLab(const fs::path& desk)
        : in_(pipe_pair()), out_(pipe_pair()) {
        Command command;
        command.arguments = {build_root() / "course" / "lab", "--work", desk};
        command.environment = plain_environment();
        command.descriptors = {{in_.first.get(), 0}, {out_.second.get(), 1}};
        process_.emplace(command);
        out_.second.reset();
    }

    /// Waits for the end of the next result. Throws SystemError when none
    /// comes.
    void wait_for_verdict() {
        std::string said;
        char buffer[4096];
        while (said.find("without a sandbox.") == said.npos) {
            pollfd p{out_.first.get(), POLLIN, 0};
            if (::poll(&p, 1, 300'000) <= 0)
                throw SystemError("lab says nothing for five minutes");
            const ssize_t n = ::read(out_.first.get(), buffer, sizeof buffer);
            if (n <= 0) throw SystemError("lab has ended: " + said);
            said.append(buffer, static_cast<std::size_t>(n));
        }
    }

private:
    DescriptorPair in_, out_;
    std::optional<Process> process_;
};

Milliseconds time_of(const auto& work) {
    const auto start = Clock::now();
    work();
    return Clock::now() - start;
}

void compile_alone(const fs::path& source, const fs::path& object) {
    Command command;
    command.arguments = {compiler(), "-std=c++20", "-c", source,
                         "-o",       object,       "-I", source_root()};
    command.environment = plain_environment();
    const Finished done = run(command, std::chrono::minutes(5), 65'536);
    if (done.status != 0) throw SystemError(done.output);
}

double median(std::vector<Milliseconds> times) {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2].count();
}

void print_medians(double to_verdict, double alone) {
    const double ratio = to_verdict / alone;
    fmt::print(
        "save to verdict {:.0f} ms, {} -c alone {:.0f} ms, medians of {}: "
        "ratio {:.2f}, at most {}: {}\n",
        to_verdict, fs::path(compiler()).filename().string(), alone, saves,
        ratio, most_ratio, ratio <= most_ratio ? "met" : "NOT met");
}

int measure() {
    const TemporaryFolder folder;
    const Desk desk{folder.path()};
    const Exercise exercise = exercise_named("face_sides");
    desk.reset(exercise);
    change_progress(
        desk, [&](Progress& progress) { progress.current = exercise.name; });
    WatchingLab lab(folder.path());
    lab.wait_for_verdict();
    std::vector<Milliseconds> to_verdict, alone;
    for (int turn = 0; turn < saves; ++turn) {
        to_verdict.push_back(time_of([&] {
            std::ofstream(desk.file(exercise)) << solution(turn);
            lab.wait_for_verdict();
        }));
        alone.push_back(time_of(
            [&] { compile_alone(desk.file(exercise), folder / "alone.o"); }));
    }
    print_medians(median(to_verdict), median(alone));
    return 0;
}

}  // namespace

}  // namespace course

int main() {
    try {
        return course::measure();
    } catch (const std::exception& error) {
        fmt::print(stderr, "save_to_verdict: {}\n", error.what());
        return 3;
    }
}
