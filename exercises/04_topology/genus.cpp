#include "exercises/04_topology/genus.h"

int genus([[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): solve Euler's equation for the one number you do not know.
    return -1;
}
