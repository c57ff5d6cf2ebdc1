// Precompiled for submissions: the table, and of the standard library what most
// of them use. It comes before a submission's first line, once, so it has no
// guard. A header that brings in <string> would cost each submission twice the
// time, even one that never uses it (40 and 80 ms, g++ 12): it compiles some
// templates of <string> anew in every file. <cmath> costs 20 ms for the same
// reason. Both are in prelude_full.h, and so is what few include: each megabyte
// of a precompiled header costs time, too.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
