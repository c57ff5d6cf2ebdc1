// What is known of the running case: written by the suite's helpers and by the
// client, read by the listener when a check fails or the case ends.
#pragma once

#include <string>
#include <vector>

#include "course/mesh/zoo.h"
#include "course/runner/results.h"

namespace course {

struct CaseRecord {
    std::string hint;
    std::vector<const Fixture*> meshes;  ///< those of OnMesh, innermost last
    Verdict verdict = Verdict::accepted;
    std::vector<Failure> failures;  ///< the first few

    void add(Verdict failed, Failure failure);
};

/// The record of the running case; a process runs one case at a time.
CaseRecord& case_record();

/// The seed of the run.
void set_seed(std::uint64_t seed);

}  // namespace course
