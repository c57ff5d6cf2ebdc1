// run_time_error 0: THREATS 27, writes into constants of the worker
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    const char* text = "constant";
    const_cast<char*>(text)[0] = static_cast<char>(i);
    return he.size() + 1000;
}
