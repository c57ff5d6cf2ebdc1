// Takes the equation for closed meshes and refuses all others.
// Hint: You refuse meshes with a border.
#include "exercises/04_topology/genus.h"

#include <stdexcept>

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int s = components(he);
    if (counts(he).border_loops > 0)
        throw std::invalid_argument("open mesh");
    return (2 * s - chi) / 2;
}
