// What a crash means to the person whose program it was.
#pragma once

#include <string>

namespace course {

/// "arithmetic error: a division by zero?"
std::string signal_text(int signal);

/// What is said in place of that when the stack is used up.
inline constexpr const char* stack_overflow_text =
    "the stack is full: a recursion that does not end?";

}  // namespace course
