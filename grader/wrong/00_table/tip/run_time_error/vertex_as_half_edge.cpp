// Reads the table at a vertex index, and then at the face index there.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    int j = he[i].fi;
    return he[j].vi;
}
