// The cost of work in a process of its own, where no memory is left over from
// the work before.
#pragma once

#include <cstdint>
#include <functional>

namespace bench {

struct Cost {
    double seconds = 0;     ///< of the processor
    std::int64_t peak = 0;  ///< bytes of memory above those at the start
};

/// Runs the work in a copy of this process. Throws std::runtime_error when the
/// work throws or the copy cannot be made. Linux only: reads /proc.
Cost cost_of(const std::function<void()>& work);

}  // namespace bench
