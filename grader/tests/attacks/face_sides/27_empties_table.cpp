// wrong_answer or run_time_error 0: THREATS 27, the table is emptied
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    const_cast<std::vector<HalfEdge>&>(he.rows()).clear();
    const_cast<std::vector<HalfEdge>&>(he.rows()).shrink_to_fit();
    return i + 1000;
}
