// Precompiled for submissions that use more of the standard library than
// prelude_streams.h has, or all of a header.

#define COURSE_WITH_SPECIAL_FUNCTIONS

#include <memory>
#include <ranges>

#include "course/runner/prelude_streams.h"
