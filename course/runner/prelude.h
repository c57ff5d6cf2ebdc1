// Precompiled for submissions: the table, and of the standard library what most
// of them use. It comes before a submission's first line, once, so it has no
// guard. A header that brings in <string> would cost each submission twice the
// time, even one that never uses it (35 and 80 ms, g++ 12): it compiles some
// templates of <string> anew in every file. <cmath> costs 20 ms for the same
// reason. Both are in prelude_full.h.

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
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
