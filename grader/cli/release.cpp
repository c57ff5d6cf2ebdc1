#include "grader/cli/commands.h"
namespace grader { void add_release(CLI::App&, int&) {} }
