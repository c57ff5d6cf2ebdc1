#include "exercises/00_table/validate.h"

std::vector<Finding> validate([[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): ask each half-edge one rule after the other.
    return {{Fault::vertex_out_of_range, -1}};
}
