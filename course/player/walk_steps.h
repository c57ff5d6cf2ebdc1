// From what the recorder and gdb wrote to the steps of a walk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "course/player/recording.h"

namespace course {

/// A line that was reached, as locals.py writes it.
struct LineReached {
    std::size_t events = 0;  ///< how many the recorder had counted before it
    int line = 0;  ///< 0: none; a function begins, or ends and has these
                   ///< values; -1: there are more that were not kept
    std::uint64_t address = 0;  ///< of its code
    std::uint64_t stack = 0;    ///< of its call; calls inside it have less
    std::string function;
    Variables variables;  ///< that have a value
    Variables left;       ///< that had one: the last one, at their end
};

/// The walks in the text that locals.py wrote; what does not fit its form ends
/// them.
std::vector<std::vector<LineReached>> read_lines_reached(std::string_view text);

/// A recorded call as a walk, still without source and expectation. `bytes` is
/// a RecordedCall, `table` the one that the function was given, `source` the
/// text of the file and `function` the exercise's. At most `most` steps are
/// kept. Throws CodecError when the bytes are none, or name what cannot be:
/// they come from the process of the submission.
RecordedWalk decode_call(std::string_view bytes, const std::vector<Row>& table,
                         std::string_view source, const std::string& function,
                         const std::vector<LineReached>& lines,
                         std::size_t most);

}  // namespace course
