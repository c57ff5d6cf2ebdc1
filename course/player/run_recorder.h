// One submission's calls, in the recorder: a process that is started again when
// a call ends it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/player/recorded_call.h"
#include "course/player/walk_steps.h"

namespace course {

/// What is recorded: with its local variables it runs under gdb.
enum class Watched { table, table_and_locals };

/// What the recorder needs: a folder for its files, the shared object that was
/// linked with an exercise's walk entry, and the source it was made from.
struct RecorderFiles {
    std::filesystem::path folder, shared, source;
};

/// A RecordedCall, or why there is none.
struct RecordedBytes {
    std::string bytes, error;
};

/// What came of it: a call for each start.
struct Recorded {
    std::string start_kind;   ///< as in Recording
    std::vector<int> starts;  ///< -1 where the function has none; empty when
                              ///< the recorder could not begin
    std::vector<RecordedBytes> calls;
    std::vector<std::vector<LineReached>> lines;  ///< of each call; empty when
                                                  ///< gdb failed
    std::string complaint;  ///< when it could not begin: why
};

/// Makes all calls. Under the limits of lab, except that calls of a submission
/// share one process. Throws SystemError, also when there is no gdb.
Recorded run_recorder(const RecorderFiles& files, RecordOrder order,
                      Watched watched);

}  // namespace course
