// The same table under other numbers: who relies on an order that the table
// does not promise is caught by it.
#pragma once

#include <cstdint>
#include <vector>

#include "course/halfedge/half_edge_table.h"

namespace course {

/// The table with its half-edges in random order; vertices and faces keep
/// their numbers. The same seed gives the same table on every machine. A
/// `next` or `opp` that is out of range stays as it is. Linear.
HalfEdgeTable renumber(const HalfEdgeTable& he, std::uint64_t seed);

/// A table under new numbers, and what became of the old ones: row i of the
/// old table is row half_edge[i] of the new, and so on.
struct Renumbering {
    HalfEdgeTable he;
    std::vector<int> half_edge, vertex, face;
};

/// As renumber, with the same half-edges for the same seed; vertices and faces
/// get new numbers as well, among those up to the largest in the table.
/// Precondition: no vi is negative, no fi below -1, and none far larger than
/// the table: the answer is as long as the largest.
Renumbering renumber_all(const HalfEdgeTable& he, std::uint64_t seed);

}  // namespace course
