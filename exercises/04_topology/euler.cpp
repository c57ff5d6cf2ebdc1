#include "exercises/04_topology/euler.h"

int euler([[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): which counts add to the characteristic, which take from
    // it?
    return -999;
}
