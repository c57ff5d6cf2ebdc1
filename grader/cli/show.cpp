#include "grader/cli/commands.h"
namespace grader { void add_show(CLI::App&, int&) {} }
