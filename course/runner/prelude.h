// Precompiled for submissions: the table, the mesh, and of the standard library
// what costs next to nothing there. It comes before a submission's first line,
// once, so it has no guard. A header that brings in <string> would cost each
// submission twice the time, even one that never uses it (43 and 104 ms, g++
// 12): the compiler instantiates what the header's inline functions use anew in
// every file, precompiled or not. Such headers are in prelude_text.h and
// prelude_full.h.

// For that reason without the special functions of mathematics, whose header of
// libstdc++ has this guard: 20 ms. Who uses them gets prelude_full.h.
#ifndef COURSE_WITH_SPECIAL_FUNCTIONS
#define _GLIBCXX_BITS_SPECFUN_H 1
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <functional>
#include <initializer_list>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <span>
#include <stack>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"
#include "course/runner/common_templates.h"
