// grader_bench: measures the grader beside other ways of grading.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "course/runner/compile.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"
#include "grader/bench/parts.h"
#include "grader/bench/ways.h"

namespace grader::bench {

namespace {

struct Part {
    const char* name;
    void (*run)(const Settings&, Report&);
};

constexpr std::array<Part, 5> all_parts = {{{"submission", submission},
                                            {"class", whole_class},
                                            {"shares", shares},
                                            {"scaling", scaling},
                                            {"build", build}}};

std::string load_average() {
    std::array<double, 3> load{};
    if (::getloadavg(load.data(), 3) != 3) return "unknown";
    return fmt::format("{:.2f} {:.2f} {:.2f}", load[0], load[1], load[2]);
}

/// The first line of what a program prints.
std::string first_line(const Arguments& arguments) {
    course::Command command;
    command.arguments = arguments;
    command.environment = course::plain_environment();
    const std::string text =
        course::run(command, std::chrono::seconds(30), 65'536).output;
    return text.substr(0, text.find('\n'));
}

/// How the grader keeps submissions apart here: from a class of one file.
std::string isolation() {
    const course::TemporaryFolder folder;
    const MadeClass made = make_class(folder.path(), {1, chosen_exercises(1)});
    return isolation_of(grade(made, folder / "out", 1));
}

void begin(Report& report) {
    report.fact("cores", std::to_string(std::thread::hardware_concurrency()));
    report.fact("compiler", first_line({course::compiler(), "--version"}));
    report.fact("isolation", isolation());
    report.fact("load average before", load_average());
    fmt::print(
        "Machines are noisy: compare within one run, and believe it when the "
        "quartiles are\nclose and the load was low before it began.\n");
}

std::vector<std::string> names_of_parts() {
    std::vector<std::string> names = {"all"};
    for (const Part& part : all_parts) names.emplace_back(part.name);
    return names;
}

void run_parts(const std::vector<std::string>& asked, Settings settings,
               Report& report) {
    const auto is_asked = [&](const std::string& name) {
        return std::find(asked.begin(), asked.end(), name) != asked.end();
    };
    const bool all = is_asked("all");
    if (all && !settings.quick && settings.students == 0)
        settings.students = 300;
    for (const Part& part : all_parts)
        if (all || is_asked(part.name)) part.run(settings, report);
}

struct Options {
    Settings settings;
    std::vector<std::string> parts = {"submission", "class", "shares"};
    std::string json;
};

void add_options(CLI::App& app, Options& options) {
    app.add_flag("--quick", options.settings.quick,
                 "few and small: two minutes that prove little");
    app.add_option("--students", options.settings.students,
                   "students of the class (60; 300 with --part all)")
        ->check(CLI::Range(1, 5000));
    app.add_option("--exercises", options.settings.exercises,
                   "exercises of the class (10), of submission and shares (15)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--jobs", options.settings.jobs,
                   "jobs of class and scaling (2)")
        ->check(CLI::Range(1, 64));
    app.add_option("--part", options.parts,
                   "submission, class, shares, scaling, build, or all "
                   "(default: the first three)")
        ->check(CLI::IsMember(names_of_parts()));
    app.add_option("--json", options.json, "write the numbers there, too");
    app.footer(
        "On two idle cores this takes about a quarter of an hour, two minutes "
        "with\n--quick, an hour and a half with --part all. Nothing is "
        "asserted: targets are\nprinted with \"met\" or \"NOT met\".\nExit "
        "code: 0 all was measured, 2 wrong usage, 3 a program that was "
        "measured\nfailed.");
}

int run(int argc, char** argv) {
    CLI::App app(
        "Measures the grader side by side with the compiler alone and with "
        "usual ways of grading.",
        "grader/bench/run");
    Options options;
    add_options(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    // Opened first: what cannot be written is to be known an hour earlier.
    std::ofstream json(options.json.empty() ? "/dev/null" : options.json);
    if (!json) {
        fmt::print(stderr, "cannot write {}\n", options.json);
        return 2;
    }
    Report report;
    begin(report);
    run_parts(options.parts, options.settings, report);
    report.fact("load average after", load_average());
    json << report.json();
    return 0;
}

}  // namespace

}  // namespace grader::bench

int main(int argc, char** argv) {
    try {
        return grader::bench::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "grader/bench: {}\n", error.what());
        return 3;
    }
}
