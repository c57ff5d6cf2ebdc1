#include "grader/bench/measure.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

#include "course/runner/process.h"

namespace grader::bench {

namespace {

constexpr std::chrono::hours most{1};

course::Finished run_to_end(course::Command command) {
    const std::string program =
        fmt::format("{}", fmt::join(command.arguments, " "));
    command.environment = course::plain_environment();
    course::Finished done = course::run(std::move(command), most, 65'536);
    if (done.timed_out || done.status != 0)
        throw MeasureError(
            fmt::format("{} {} (status {}):\n{}", program,
                        done.timed_out ? "took an hour" : "failed", done.status,
                        done.output));
    return done;
}

double seconds_since(course::Clock::time_point start) {
    return std::chrono::duration<double>(course::Clock::now() - start).count();
}

/// The number of a process, which it wrote into the pipe when it started.
std::string read_number(const course::Descriptor& pipe) {
    std::string number;
    for (char c = 0; ::read(pipe.get(), &c, 1) == 1 && c != '\n';) number += c;
    return number;
}

/// Its high water mark in KiB; 0 when it has ended.
double high_water(const std::string& process) {
    std::ifstream status("/proc/" + process + "/status");
    const std::string key = "VmHWM:";
    for (std::string word; status >> word;)
        if (double kib = 0; word == key && status >> kib) return kib;
    return 0;
}

/// The peak of the process that tells its number through `pipe`.
double watch(const course::Descriptor& pipe, const std::stop_token& stop) {
    const std::string process = read_number(pipe);
    double peak = 0;
    while (!process.empty() && !stop.stop_requested()) {
        peak = std::max(peak, high_water(process));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return peak;
}

}  // namespace

double quantile(Samples samples, double part) {
    std::sort(samples.begin(), samples.end());
    const double at = part * static_cast<double>(samples.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(at));
    const auto above = static_cast<std::size_t>(std::ceil(at));
    return std::lerp(samples[below], samples[above], at - std::floor(at));
}

Samples ratios(const Samples& above, const Samples& below) {
    Samples list;
    for (std::size_t k = 0; k < std::min(above.size(), below.size()); ++k)
        list.push_back(above[k] / below[k]);
    return list;
}

double seconds_of(const Arguments& arguments) {
    course::Command command;
    command.arguments = arguments;
    const auto start = course::Clock::now();
    run_to_end(std::move(command));
    return seconds_since(start);
}

Measured measure(const Arguments& arguments) {
    course::DescriptorPair pipe = course::pipe_pair();
    double peak = 0;
    std::jthread watcher(
        [&](const std::stop_token& stop) { peak = watch(pipe.first, stop); });
    // Gone before the watcher is waited for, who may still be reading.
    const course::Descriptor ours = std::move(pipe.second);
    course::Command command;
    // The shell becomes the program, whose number is then known.
    command.arguments = {"setpriv", "--pdeathsig",
                         "TERM",    "sh",
                         "-c",      R"(echo $$ >&9; exec 9>&-; exec "$@")",
                         "sh"};
    command.arguments.insert(command.arguments.end(), arguments.begin(),
                             arguments.end());
    command.descriptors = {{ours.get(), 9}};
    const auto start = course::Clock::now();
    const course::Finished done = run_to_end(std::move(command));
    const double seconds = seconds_since(start);
    watcher.request_stop();
    watcher.join();
    return {seconds, peak / 1024, done.output};
}

}  // namespace grader::bench
