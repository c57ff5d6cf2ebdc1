// What lab tells the recorder, and what the recorder writes: files of its own,
// so that nothing that a submission prints comes between.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// The recorder's order.
struct RecordOrder {
    IndexedMesh mesh;
    std::vector<HalfEdge> rows;
    std::vector<int> starts;  ///< empty: all
    std::uint32_t done = 0;   ///< how many of them are recorded already
    std::uint64_t most = 0;   ///< events that are kept of a call
};

#if COURSE_TABLE == 2
/// One call. What the recorder writes is a list of them, each after its length
/// (64 bits); before them the start of each call that it is going to make, -1
/// for a function that has no start.
struct RecordedCall {
    std::string call;        ///< "(he, 4)"
    std::string result;      ///< as JSON; empty when it did not return
    std::string error;       ///< why it did not
    std::uint64_t size = 0;  ///< events in all; kept are the first ones
    std::vector<TraceEvent> events = {};
};
#endif

}  // namespace course
