#include "course/runner/signal_text.h"

#include <fmt/format.h>

#include <csignal>

namespace course {

std::string signal_text(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "segmentation fault: it used a bad pointer or an "
                   "index far outside an array";
        case SIGBUS:
            return "bus error: it used a bad pointer";
        case SIGFPE:
            return "arithmetic error: a division by zero?";
        case SIGILL:
            return "illegal instruction: does every path of the "
                   "function return a value?";
        case SIGABRT:
            return "aborted: an assertion of the library failed, or "
                   "an exception was not caught";
        case SIGTRAP:
            return "trapped: does every path of the function return "
                   "a value?";
        default:
            return fmt::format("ended by signal {}", signal);
    }
}

}  // namespace course
