// Precompiled for submissions that read or write text.

#include <charconv>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "course/runner/prelude_text.h"
