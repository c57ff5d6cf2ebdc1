// The student's and the lecturer's command line.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "course/cli/commands.h"
#include "course/player/page_server.h"
#include "course/player/record.h"
#include "course/runner/exercises.h"

namespace course {

namespace {

void add_commands(CLI::App& program, const Desk& desk, int& code) {
    add_check(program, desk, code);
    add_hint(program, desk, code);
    add_list(program, desk, code);
    add_next(program, desk, code);
    add_status(program, desk, code);
    add_reset(program, desk, code);
    add_submit(program, desk, code);
    add_doctor(program, desk, code);
    add_demo(program, desk, code);
    add_figures(program, code);
    add_clean(program, code);
}

int run_lab(CLI::App& program, int argc, char** argv) {
    program.require_subcommand(0, 1);
    Desk desk;
    int code = 0;
    program
        .add_option("--work", desk.root,
                    "folder with your exercises/, if not the one of lab")
        ->check(CLI::ExistingDirectory);
    add_commands(program, desk, code);
    program.parse(argc, argv);
    return program.get_subcommands().empty() ? watch(desk) : code;
}

int complain(const std::exception& error, int code) {
    fmt::print(stderr, "lab: {}\n", error.what());
    return code;
}

}  // namespace

}  // namespace course

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    CLI::App program(
        "Exercises on the half-edge table: write the function, check it, be "
        "told what went wrong in terms of half-edges. Without a command: "
        "watches the current exercise and checks it when it is saved.",
        "lab");
    try {
        return course::run_lab(program, argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    } catch (const course::UnknownExercise& error) {
        return course::complain(error, 2);
    } catch (const course::CannotBegin& error) {
        return course::complain(error, 2);
    } catch (const course::CannotShow& error) {
        return course::complain(error, 2);
    } catch (const course::CannotServe& error) {
        return course::complain(error, 2);
    } catch (const std::exception& error) {
        return course::complain(error, 3);
    }
}
