// run_time_error or time_limit_exceeded 0: THREATS 44, an exception whose text never ends to be made
#include "exercises/01_traversal/face_sides.h"
#include <exception>

struct Bad : std::exception {
    const char* what() const noexcept override { for (;;) {} }
};
int face_sides(const HalfEdgeTable& he, int i) {
    if (he.size() > i) throw Bad();
    return 0;
}
