#include "grader/cli/commands.h"
namespace grader { void add_run(CLI::App&, int&) {} }
