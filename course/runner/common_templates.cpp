// Part of each program that loads submissions: what they find there.
#include "course/runner/text_templates.h"

#define COURSE_COMPILED_HERE(...) template __VA_ARGS__
COURSE_COMMON_TEMPLATES(COURSE_COMPILED_HERE)
COURSE_TEXT_TEMPLATES(COURSE_COMPILED_HERE)
