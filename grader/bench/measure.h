// How long programs take, how much memory the grader needs, and the numbers
// that are made of it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace grader::bench {

using Arguments = std::vector<std::string>;

/// One number for each round.
using Samples = std::vector<double>;

/// The median for part 0.5, the quartiles for 0.25 and 0.75. Precondition:
/// there is a sample.
double quantile(Samples samples, double part);

/// above / below in each round that has both: what slows the machine down for
/// a while slows both.
Samples ratios(const Samples& above, const Samples& below);

/// Thrown when a program fails that is measured: its time would say nothing.
struct MeasureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Seconds from the start of a program to its end. Throws MeasureError when its
/// exit code is not 0 or it takes an hour, SystemError when it cannot start.
double seconds_of(const Arguments& arguments);

/// What a run of a program took, and what it printed.
struct Measured {
    double seconds = 0;
    double peak_mib = 0;  ///< resident, of this one process
    std::string output;
};

/// For programs that run for long: they are told to end when this one does.
/// Asks for the memory every few milliseconds, so the very last may be missed.
/// Throws as seconds_of.
Measured measure(const Arguments& arguments);

}  // namespace grader::bench
