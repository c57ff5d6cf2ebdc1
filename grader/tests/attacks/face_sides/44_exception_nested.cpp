// run_time_error 0: THREATS 44, an exception out of the destructor of an exception
#include "exercises/01_traversal/face_sides.h"

struct Bad { ~Bad() noexcept(false) { throw 1; } };
int face_sides(const HalfEdgeTable& he, int i) {
    if (he.size() > i) throw Bad();
    return 0;
}
