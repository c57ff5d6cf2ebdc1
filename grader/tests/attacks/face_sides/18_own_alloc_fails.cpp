// wrong_answer or run_time_error or memory_limit_exceeded 0: THREATS 18, malloc always fails
#include "exercises/01_traversal/face_sides.h"
#include <new>

extern "C" void* malloc(unsigned long) { return nullptr; }
void* operator new(std::size_t) { throw std::bad_alloc(); }
void operator delete(void*) noexcept {}
int face_sides(const HalfEdgeTable& he, int i) { return *new int(he.size() + i); }
