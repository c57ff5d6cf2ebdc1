// he[...] beside a raw pointer, compiled by each compiler at each level.
#pragma once

#include <vector>

#include "course/halfedge/half_edge_table.h"

namespace bench {

/// One compilation of subscript.cpp; each adds itself to `subscripts`.
struct Subscript {
    const char* compiled;  ///< `g++ -O2`
    long (*raw)(const HalfEdge* he, const int* leaving, int vertices);
    long (*checked)(const HalfEdgeTable& he, const int* leaving, int vertices);
};

std::vector<Subscript>& subscripts();

}  // namespace bench
