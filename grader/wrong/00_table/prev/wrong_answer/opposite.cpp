// Takes the opposite, which arrives at the vertex but along another face.
// Hint: You give a half-edge that arrives at the vertex, but along another
// face.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    return he[i].opp;
}
