// As common_templates.h, for submissions that have <string>. (fill_hole: 140 ms
// of CPU to compile without it, 90 ms with it; g++ 12)
#pragma once

#include <string>
#include <vector>

#include "course/runner/common_templates.h"

// What std::stoi and its like are made of in libstdc++, and std::to_string.
#ifdef __GLIBCXX__
#define COURSE_NUMBER(instantiate, Char, Number, Read, ...)                   \
    instantiate(Number __gnu_cxx::__stoa<Read, Number,                        \
                                         Char __VA_OPT__(, ) __VA_ARGS__>(    \
        Read(*)(const Char*, Char** __VA_OPT__(, ) __VA_ARGS__), const char*, \
        const Char*, std::size_t* __VA_OPT__(, ) __VA_ARGS__));
#define COURSE_NUMBERS(instantiate, Char)                                    \
    COURSE_NUMBER(instantiate, Char, int, long, int)                         \
    COURSE_NUMBER(instantiate, Char, long, long, int)                        \
    COURSE_NUMBER(instantiate, Char, unsigned long, unsigned long, int)      \
    COURSE_NUMBER(instantiate, Char, long long, long long, int)              \
    COURSE_NUMBER(instantiate, Char, unsigned long long, unsigned long long, \
                  int)                                                       \
    COURSE_NUMBER(instantiate, Char, float, float)                           \
    COURSE_NUMBER(instantiate, Char, double, double)                         \
    COURSE_NUMBER(instantiate, Char, long double, long double)               \
    instantiate(                                                             \
        std::basic_string<Char>                                              \
            __gnu_cxx::__to_xstring<std::basic_string<Char>, Char>(          \
                int (*)(Char*, std::size_t, const Char*, __builtin_va_list), \
                std::size_t, const Char*, ...));
#else
#define COURSE_NUMBERS(instantiate, Char)
#endif

#define COURSE_TEXT_TEMPLATES(instantiate)      \
    COURSE_NUMBERS(instantiate, char)           \
    COURSE_NUMBERS(instantiate, wchar_t)        \
    instantiate(class std::basic_string<char>); \
    COURSE_VECTOR(instantiate, std::string)

COURSE_TEXT_TEMPLATES(COURSE_COMPILED_IN_THE_WORKER)
