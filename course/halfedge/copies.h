// A table of any size that travels in a few kilobytes: many copies of a small
// one, numbered in one mix.
#pragma once

#include <cstdint>
#include <vector>

#include "course/halfedge/half_edge_table.h"

namespace course {

/// Copies of one table, apart from each other.
struct Copies {
    std::vector<HalfEdge> tile;  ///< the rows that are copied
    std::int32_t vertices = 0;   ///< of the tile; its `vi` are below
    std::int32_t faces = 0;      ///< of the tile; its `fi` are below
    std::int32_t count = 0;      ///< how many copies
    std::uint64_t seed = 0;      ///< of the mix
};

/// The numbers that half-edges, vertices or faces get: `of_each` in a tile.
/// Number k of copy c is (a (k count + c) + b) mod (of_each count), where a has
/// no divisor in common with the whole: each number once, far from its
/// neighbours, and found without a list.
class MixedNumbers {
public:
    MixedNumbers(std::int32_t of_each, const Copies& copies);

    /// Precondition: k is a number of the tile and c one of a copy. -1, the
    /// face of a border half-edge, stays -1.
    int operator()(int k, int c) const;

    std::uint64_t size() const { return size_; }

    /// k count + c for number 0, and by how much it grows from one number to
    /// the next; both mod size().
    std::uint64_t first() const;
    std::uint64_t step() const;

private:
    std::uint64_t count_, size_, factor_, shift_;
};

/// All copies in one table. Linear, some 5 ns for each half-edge.
/// Precondition: the tile is valid, and there are less than 2^31 rows in all.
HalfEdgeTable table_of(const Copies& copies);

}  // namespace course
