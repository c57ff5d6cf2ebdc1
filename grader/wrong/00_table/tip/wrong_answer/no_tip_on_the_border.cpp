// Treats the border as an error, but a border half-edge has a tip.
// Hint: You refuse a half-edge on the border; it arrives at a vertex like any
// other.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return -1;
    return he[he[i].next].vi;
}
