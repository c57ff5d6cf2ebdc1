// he[...] beside a raw pointer, compiled by each compiler at each level.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace bench {

/// vi, fi, next, opp: each build of the table has a row of its own type.
using Rows = std::vector<std::array<int, 4>>;

/// A walk over all stars that can be called again and again. `leaving`: for
/// each vertex a half-edge that leaves it, or -1.
using Walker = std::function<double()> (*)(const Rows& rows,
                                           const std::vector<int>& leaving);

/// One compilation of subscript.cpp; each adds itself to `subscripts`.
struct Subscript {
    const char* compiled;  ///< `g++ -O2`
    bool traced;           ///< else checked
    Walker table;          ///< by he[...]
    Walker raw;            ///< by a raw pointer
};

std::vector<Subscript>& subscripts();

}  // namespace bench
