// The grader's command line.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "course/runner/exercises.h"
#include "course/runner/process.h"
#include "grader/cli/commands.h"

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    CLI::App program(
        "Grades exercises on the half-edge table: compiles each submission and "
        "runs it in a sandbox, judges it from outside with hidden suites.",
        "grader");
    program.require_subcommand(1);
    int code = 0;
    grader::add_run(program, code);
    grader::add_regrade(program, code);
    grader::add_judge(program, code);
    grader::add_validate(program, code);
    grader::add_show(program, code);
    grader::add_history(program, code);
    grader::add_diff(program, code);
    grader::add_override(program, code);
    grader::add_export(program, code);
    grader::add_plagiarism(program, code);
    grader::add_release(program, code);
    grader::add_assignment(program, code);
    grader::add_doctor(program, code);
    grader::add_work(program, code);
    try {
        // Before the first program is started, also by the build.
        course::end_programs_with_this_process();
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const course::UnknownExercise& error) {
        fmt::print(stderr, "grader: {}\n", error.what());
        return 2;
    } catch (const grader::CannotBegin& error) {
        fmt::print(stderr, "grader: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "grader: {}\n", error.what());
        return 3;
    }
    return code;
}
