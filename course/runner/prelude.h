// Precompiled for submissions: the table, and what the contracts name. It comes
// before a submission's first line, once, so it has no guard.

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "course/halfedge/half_edge_table.h"
