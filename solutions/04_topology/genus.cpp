#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    // chi = 2 (S - G) - B, so 2 G = 2 S - B - chi
    int b = counts(he).border_loops;
    return (2 * components(he) - b - euler(he)) / 2;
}
