// run_time_error 0: THREATS 44, an exception whose text is no text
#include "exercises/01_traversal/face_sides.h"
#include <exception>

struct Bad : std::exception {
    const char* what() const noexcept override { return reinterpret_cast<const char*>(8); }
};
int face_sides(const HalfEdgeTable& he, int i) {
    if (he.size() > i) throw Bad();
    return 0;
}
