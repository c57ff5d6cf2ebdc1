// Gives the vertex that i leaves, not the one it arrives at.
// Hint: You give the vertex that the half-edge leaves.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    return he[i].vi;
}
