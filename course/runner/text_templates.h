// As common_templates.h, for submissions that have <string>. (fill_hole: 140 ms
// of CPU to compile without it, 90 ms with it; g++ 12)
#pragma once

#include <string>
#include <vector>

#include "course/runner/common_templates.h"

#ifdef __GLIBCXX__
#define COURSE_TEXT_BASES(instantiate) \
    instantiate(                       \
        struct std::_Vector_base<std::string, std::allocator<std::string>>);
#else
#define COURSE_TEXT_BASES(instantiate)
#endif

#define COURSE_TEXT_TEMPLATES(instantiate)      \
    COURSE_TEXT_BASES(instantiate)              \
    instantiate(class std::basic_string<char>); \
    instantiate(class std::vector<std::string>);

COURSE_TEXT_TEMPLATES(COURSE_COMPILED_IN_THE_WORKER)
