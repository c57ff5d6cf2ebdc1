// time_limit_exceeded 10: THREATS 27, looks through the whole table by rows(), which counts nothing
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    const int face = he.rows()[static_cast<std::size_t>(i)].fi;
    if (face == -1) return 0;
    int sides = 0;
    for (const HalfEdge& row : he.rows()) sides += row.fi == face ? 1 : 0;
    return sides;
}
