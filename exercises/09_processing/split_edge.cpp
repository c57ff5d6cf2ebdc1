#include "exercises/09_processing/split_edge.h"

HalfEdgeTable split_edge([[maybe_unused]] const HalfEdgeTable& he,
                         [[maybe_unused]] int i,
                         [[maybe_unused]] int new_vertex) {
    // TODO(student): cut the edge in two first, then each triangle along it.
    return HalfEdgeTable();
}
