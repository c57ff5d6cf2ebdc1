// Takes the neighbouring row for the opposite: i ^ 1 is not opp.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    return he[i ^ 1].vi;
}
