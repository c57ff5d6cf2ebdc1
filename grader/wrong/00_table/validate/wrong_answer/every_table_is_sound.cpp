// Finds nothing, ever.
// Hint: You report nothing.
#include "exercises/00_table/validate.h"

std::vector<Finding> validate(const HalfEdgeTable&) {
    return {};
}
