// Gives the vertex that i leaves, not the one it arrives at.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    return he[i].vi;
}
