// The commands of lab. Each gives the exit code of the process: 0 good, 1 not
// accepted, 2 wrong usage, 3 lab itself failed.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "course/cli/desk.h"
#include "course/runner/statement.h"

namespace course {

/// Thrown when a command cannot begin; the message says why. Exit code 2.
struct CannotBegin : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The student's language: that of LAB_LANG ("en", "it"), else English. Throws
/// CannotBegin where there is no such language.
Language language();

/// The statement in the student's language; where it has to be in another one,
/// its text begins with a line that says so.
Statement own_statement(const Exercise& exercise);

/// Prints it for people to read.
void print_statement(const Exercise& exercise);

/// Adds the command to the program; `code` is set when it runs, on `desk` as it
/// is then. Both outlive the program.
void add_check(CLI::App& program, const Desk& desk, int& code);
void add_clean(CLI::App& program, int& code);
void add_demo(CLI::App& program, const Desk& desk, int& code);
void add_doctor(CLI::App& program, const Desk& desk, int& code);
void add_figures(CLI::App& program, int& code);
void add_hint(CLI::App& program, const Desk& desk, int& code);
void add_list(CLI::App& program, const Desk& desk, int& code);
void add_next(CLI::App& program, const Desk& desk, int& code);
void add_reset(CLI::App& program, const Desk& desk, int& code);
void add_status(CLI::App& program, const Desk& desk, int& code);
void add_submit(CLI::App& program, const Desk& desk, int& code);

/// Without a command: watches the current exercise.
int watch(const Desk& desk);

}  // namespace course
