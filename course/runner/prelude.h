// Precompiled for submissions: the table, the mesh, and of the standard library
// what costs next to nothing there. It comes before a submission's first line,
// once, so it has no guard. An empty file takes 21 ms with it, 33 with
// prelude_text.h, 45 with prelude_streams.h and 66 with prelude_full.h (g++
// 12), even when it uses nothing of them: the compiler instantiates what the
// inline functions of a header use anew in every file, precompiled or not.

// For that reason without the special functions of mathematics, whose header of
// libstdc++ has this guard: 20 ms. Who uses them gets prelude_full.h.
#ifndef COURSE_WITH_SPECIAL_FUNCTIONS
#define _GLIBCXX_BITS_SPECFUN_H 1
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <climits>
#include <cmath>
#include <compare>
#include <concepts>
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
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <span>
#include <stack>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"
#include "course/runner/common_templates.h"
