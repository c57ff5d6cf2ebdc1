#include "grader/bench/ways.h"

#include <fmt/format.h>

#include <fstream>

#include "course/runner/compile.h"

namespace grader::bench {

namespace {

namespace fs = std::filesystem;
using course::source_root;

/// What the build says a suite is linked with.
Arguments libraries() {
    std::ifstream list(course::build_root() / "grader" / "bench" /
                       "libraries.txt");
    Arguments files;
    for (std::string line; std::getline(list, line);) files.push_back(line);
    if (files.empty()) throw MeasureError("the build made no libraries.txt");
    return files;
}

/// The submission, the references that it builds on, and both of its suites.
Arguments sources(const HandedIn& handed) {
    const fs::path suite =
        fs::path(handed.exercise.topic) / (handed.exercise.name + "_test.cpp");
    Arguments files = {handed.file, source_root() / "exercises" / suite,
                       source_root() / "grader" / "suites" / suite};
    for (const course::Exercise& before :
         course::exercises_before(handed.exercise))
        files.push_back(before.solution());
    return files;
}

/// A build of an earlier submission would be a head start.
void make_empty(const fs::path& folder) {
    fs::remove_all(folder);
    fs::create_directories(folder);
}

std::string quoted(const Arguments& paths) {
    std::string text;
    for (const std::string& path : paths)
        text += fmt::format("\n    \"{}\"", path);
    return text;
}

std::string project_of(const HandedIn& handed) {
    return fmt::format(
        "cmake_minimum_required(VERSION 3.25)\n"
        "project(submission LANGUAGES CXX)\n"
        "set(CMAKE_CXX_STANDARD 20)\n"
        "add_executable(tests{})\n"
        "target_include_directories(tests PRIVATE \"{}\")\n"
        "target_link_libraries(tests PRIVATE{})\n",
        quoted(sources(handed)), source_root().string(), quoted(libraries()));
}

}  // namespace

Measured grade(const MadeClass& made, const fs::path& out, int jobs) {
    return measure({course::build_root() / "grader" / "grader", "run",
                    made.folder, "--out", out, "--assignment", made.assignment,
                    "--jobs", std::to_string(jobs)});
}

std::string isolation_of(const Measured& run) {
    const std::string key = "Isolation: ";
    const auto at = run.output.find(key);
    if (at == std::string::npos) return "not said";
    const auto begin = at + key.size();
    return run.output.substr(begin, run.output.find('\n', begin) - begin);
}

double compile_alone(const HandedIn& handed, const fs::path& scratch) {
    return seconds_of({course::compiler(), "-std=c++20", "-O0", "-c",
                       "-I" + source_root().string(), handed.file, "-o",
                       scratch / "alone.o"});
}

double one_command(const HandedIn& handed, const fs::path& scratch) {
    const fs::path main = scratch / "main.cpp";
    std::ofstream(main) << "#define CATCH_CONFIG_MAIN\n"
                           "#include \"course/runner/catch2.h\"\n";
    const fs::path program = scratch / "tests";
    Arguments command = {course::compiler(),
                         "-std=c++20",
                         "-O0",
                         "-I" + source_root().string(),
                         "-o",
                         program,
                         main};
    for (const Arguments& more : {sources(handed), libraries()})
        command.insert(command.end(), more.begin(), more.end());
    return seconds_of(command) + seconds_of({program});
}

double cmake_project(const HandedIn& handed, const fs::path& scratch) {
    const fs::path folder = scratch / "project";
    make_empty(folder);
    std::ofstream(folder / "CMakeLists.txt") << project_of(handed);
    const fs::path build = folder / "build";
    return seconds_of({"cmake", "-S", folder, "-B", build, "-G", "Ninja",
                       "-DCMAKE_CXX_COMPILER=" + course::compiler()}) +
           seconds_of({"cmake", "--build", build, "--parallel", "1"}) +
           seconds_of({build / "tests"});
}

}  // namespace grader::bench
