// run_time_error 0: THREATS 44, exceptions of the runner's own types
#include "exercises/01_traversal/face_sides.h"
#include <stdexcept>
#include <string>

namespace course { struct WorkerFailed {}; struct CodecError : std::runtime_error { using std::runtime_error::runtime_error; }; }
int face_sides(const HalfEdgeTable& he, int i) {
    if (i % 2 == 0) throw course::WorkerFailed{};
    throw course::CodecError("accepted " + std::to_string(he.size()));
}
