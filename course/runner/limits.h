// What a submission may use. One set of values for lab and grader, so that
// what passes at home passes in grading; an assignment may have others, which
// are then in the copy for its students, too.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>

namespace course {

struct Limits {
    /// Wall time of one call, in milliseconds.
    std::int32_t call_ms = 2000;
    /// Wall time of one call after the submission has once exceeded its limit:
    /// honest calls take microseconds, and ten cases must not hang for 20 s.
    std::int32_t later_call_ms = 200;
    /// Calls that may run out of time before the remaining cases are not run.
    std::int32_t max_timeouts = 4;
    /// Wall time and CPU time of one case (one worker).
    std::int32_t case_ms = 5000;
    std::int32_t cpu_seconds = 4;
    /// CPU time in which it must end or take more memory: an endless loop that
    /// reads no table is found out by this, and one that takes memory goes on
    /// to its limit. After the first of them the next cases get less.
    std::int32_t cpu_ms = 250;
    std::int32_t later_cpu_ms = 100;
    /// Wall time of all cases together, of each run of them: slow answers that
    /// keep below the limits of each case must not outlast the judge.
    std::int32_t run_ms = 20'000;
    /// Address space of a worker.
    std::int32_t memory_mib = 512;
    std::int32_t stack_mib = 8;
    /// What one worker may print; one byte more ends it.
    std::int32_t output_kib = 2048;
    /// The longest reply to one call, beside what the tables in it take: any
    /// right answer is far shorter, and a message is made of it when it fails.
    std::int32_t reply_kib = 256;
    /// The longest file that is compiled.
    std::int32_t source_kib = 4096;

    friend auto operator<=>(const Limits&, const Limits&) = default;
};

/// What the file .lab/limits of a student's copy says of exercises, by name: a
/// line for each, the name and the numbers of Limits in their order. Lines that
/// say something else are left out.
std::string limits_file(const std::map<std::string, Limits>& limits);
std::map<std::string, Limits> read_limits_file(const std::string& text);

}  // namespace course
