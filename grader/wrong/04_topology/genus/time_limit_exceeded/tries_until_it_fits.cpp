// Tries one genus after the other, from 1 on: never comes to 0.
// Hint: You try one number after the other, and never meet the right one.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    int g = 1;
    while (2 * (s - g) - b != chi) ++g;
    return g;
}
