// run_time_error 0: THREATS 44, an exception with a text of 50 MB
#include "exercises/01_traversal/face_sides.h"
#include <stdexcept>
#include <string>

int face_sides(const HalfEdgeTable& he, int i) {
    throw std::runtime_error(std::string(50'000'000, 'x') + std::to_string(i + he.size()));
}
