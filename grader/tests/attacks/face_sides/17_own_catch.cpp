// wrong_answer 0: THREATS 17, own functions by the names of Catch2
#include "exercises/01_traversal/face_sides.h"

namespace Catch {
struct AssertionResult { bool isOk() const; bool succeeded() const; };
bool AssertionResult::isOk() const { return true; }
bool AssertionResult::succeeded() const { return true; }
}
int face_sides(const HalfEdgeTable&, int) { return -9; }
