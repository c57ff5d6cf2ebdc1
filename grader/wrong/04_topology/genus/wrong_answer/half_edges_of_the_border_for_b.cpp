// Takes for B how many half-edges the border has.
// Hint: You are right on closed meshes; where there is a border, its loops do
// not go into your number as they should.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = 0;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) ++b;
    int s = components(he);
    return (2 * s - chi - b) / 2;
}
