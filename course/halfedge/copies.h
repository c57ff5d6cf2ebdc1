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

/// The numbers that half-edges, vertices or faces get: `of_each` in a tile. The
/// copies of one number are neighbours, in another order than the copies, and
/// numbers of the tile change places: number k of copy c is
/// count ((a k + b) mod of_each) + (d c + e) mod count.
class MixedNumbers {
public:
    MixedNumbers(std::int32_t of_each, const Copies& copies);

    /// Precondition: k is a number of the tile and c one of a copy. -1, the
    /// face of a border half-edge, stays -1.
    int operator()(int k, int c) const;

    /// The first of the numbers that k has in all copies; -1 of -1.
    int block(int k) const;

    std::size_t size() const {
        return static_cast<std::size_t>(places_.size) *
               static_cast<std::size_t>(slots_.size);
    }

private:
    /// x -> (factor x + shift) mod size, each value once.
    struct Mix {
        std::int64_t size = 0, factor = 0, shift = 0;

        Mix(std::int64_t n, std::uint64_t seed);
        std::int64_t of(std::int64_t x) const {
            return (factor * x + shift) % size;
        }
    };

    Mix places_, slots_;
};

/// All copies in one table. Linear, 2 ns for each half-edge.
/// Precondition: the tile is valid, and there are less than 2^31 rows in all.
HalfEdgeTable table_of(const Copies& copies);

}  // namespace course
