#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) { return he[he[i].opp].vi; }