// Catch2's main for the tests of the framework.
#define CATCH_CONFIG_MAIN
#include "course/runner/catch2.h"
