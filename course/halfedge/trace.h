// From the events of the traced build to steps that can be shown: which cell of
// the table was read or written, by which expression of the source.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "course/halfedge/half_edge_table.h"

#if COURSE_TABLE == 2

namespace course {

/// One read or write of the table.
struct TraceStep {
    int i;              ///< the half-edge
    std::string field;  ///< vi, fi, next or opp; empty when the source names
                        ///< none, as in `HalfEdge h = he[i];`
    int line;           ///< of the expression he[i].next, from 1; 0 when it is
                        ///< not known
    int from, to;       ///< its columns in bytes, from 1, `to` is the one
                        ///< after it; of an expression over several lines,
                        ///< those on the line with the ]; 0 when not known
    bool write;
    int value;           ///< of the cell, after the write; 0 without a field
    int before;          ///< and before it; the same for a read
    bool added = false;  ///< the row is new: by push_back
    int table = 0;       ///< as in TraceEvent

    friend bool operator==(const TraceStep&, const TraceStep&) = default;
};

/// The steps of a recorded call, in order. `initial` is the table when the
/// recording started and `source` the text that was compiled; the field is
/// read there, after the ]. A write that the source does not show at the
/// subscript, as through a reference, follows the step after which it was
/// seen, and is placed where its row was last taken from the table.
/// Both compilers give the same steps, except for an index that begins with a
/// macro which itself reads the table.
std::vector<TraceStep> trace_steps(const std::vector<TraceEvent>& events,
                                   const HalfEdgeTable& initial,
                                   std::string_view source);

/// The same steps, and where those of each event begin: steps of event k are
/// first[k] to first[k + 1].
struct StepsByEvent {
    std::vector<TraceStep> steps;
    std::vector<std::size_t> first;
};
StepsByEvent steps_by_event(const std::vector<TraceEvent>& events,
                            const HalfEdgeTable& initial,
                            std::string_view source);

}  // namespace course

#endif
