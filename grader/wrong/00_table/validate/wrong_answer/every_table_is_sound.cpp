// Finds nothing, ever.
#include "exercises/00_table/validate.h"

std::vector<Finding> validate(const HalfEdgeTable&) {
    return {};
}
