// What the suites of fans and strips have in common.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "course/mesh/tri.h"
#include "course/runner/suite.h"

namespace course::hidden {

/// Each triangle, begun at its smallest vertex; one with a vertex twice stays
/// as it is.
inline std::vector<Tri> from_smallest(std::vector<Tri> triangles) {
    for (Tri& t : triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return triangles;
}

/// The same triangles in the same order, each begun anywhere.
inline ListMatcher<std::vector<Tri>> are_triangles(std::vector<Tri> expected) {
    return {std::move(expected), from_smallest,
            "are, each begun at any of its vertices: "};
}

/// `size` numbers below `below`, at random.
inline std::vector<int> random_list(std::size_t size, std::uint64_t below,
                                    std::mt19937_64& random) {
    std::vector<int> list(size);
    for (int& v : list) v = static_cast<int>(random() % below);
    return list;
}

/// The numbers from 0 to size - 1 in random order.
inline std::vector<int> shuffled(std::size_t size, std::mt19937_64& random) {
    std::vector<int> list(size);
    for (std::size_t k = 0; k < size; ++k) {
        list[k] = static_cast<int>(k);
        std::swap(list[k], list[random() % (k + 1)]);
    }
    return list;
}

}  // namespace course::hidden
