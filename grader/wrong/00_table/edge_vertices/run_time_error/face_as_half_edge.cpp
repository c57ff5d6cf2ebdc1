// Looks up the face index in the table: on the border that is he[-1].
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int j = he[i].fi;
    return {he[i].vi, he[j].vi};
}
