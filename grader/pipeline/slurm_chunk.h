// A node's part of a job on a cluster.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

#include "grader/pipeline/executor.h"
#include "grader/pipeline/slurm_job.h"

namespace grader {

/// How long a result is kept back before it is written.
constexpr std::chrono::milliseconds settling_time{1000};

/// Judges those tasks of a chunk that have no result yet, and writes theirs.
/// True when all have one in the end.
///
/// `disturbed` becomes true when the cluster ends or freezes this process: it
/// does the same to the processes of submissions, which then seem to have
/// crashed or to be slow. So a result counts only if nothing of that kind
/// happens for a while after it, and nothing more is begun.
/// Precondition: chunk < job.chunks(). Throws course::SystemError.
bool judge_chunk(const JobFolder& folder, const Job& job, std::size_t chunk,
                 Executor& executor, const std::function<bool()>& disturbed);

}  // namespace grader
