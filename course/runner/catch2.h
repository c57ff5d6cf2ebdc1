// Catch2 2.13 and 3 under one include: Debian has the one, Ubuntu and Homebrew
// the other.
#pragma once

// Messages show the entries of a map.
#define CATCH_CONFIG_ENABLE_PAIR_STRINGMAKER

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#define COURSE_CATCH2 3
#else
#include <catch2/catch.hpp>
#define COURSE_CATCH2 2
#endif
