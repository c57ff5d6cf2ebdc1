// The walk that a call took through the table, put into words and numbers.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "course/halfedge/half_edge_table.h"

namespace grader {

/// A walk by half-edges: rows read several times in a row count once.
struct Walk {
    std::vector<int> steps;      ///< when it repeats: one turn of it
    bool from_the_start = true;  ///< false: earlier steps were not kept
    bool repeats = false;        ///< it went round and round to the end
    std::int64_t reads = 0;      ///< of the table, in all
};

/// The walk behind the last `visits` of a call that read `reads` rows.
Walk walk_of(std::span<const Visit> visits, std::int64_t reads);

/// "he[1] he[0] he[2] and stopped", "he[4] he[11], again and again (100000
/// reads)"; empty for no walk.
std::string walk_text(const Walk& walk);

/// For each half-edge of the walk when it came to it: "1", "2, 5", "1, 2, ...".
/// Without numbers where the start was not kept.
std::map<int, std::string> walk_order(const Walk& walk);

}  // namespace grader
