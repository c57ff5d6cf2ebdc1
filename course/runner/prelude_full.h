// Precompiled for submissions that use more of the standard library than
// prelude_text.h has, or all of a header.

#define COURSE_WITH_SPECIAL_FUNCTIONS

#include <iomanip>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>

#include "course/runner/prelude_text.h"
