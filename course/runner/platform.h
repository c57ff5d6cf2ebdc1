// What only Linux has is used behind #if COURSE_LINUX, and has something else
// in its place on other systems. COURSE_PORTABLE takes that here, too, so that
// it can be tried.
#pragma once

#if defined(__linux__) && !defined(COURSE_PORTABLE)
#define COURSE_LINUX 1
#else
#define COURSE_LINUX 0
#endif
