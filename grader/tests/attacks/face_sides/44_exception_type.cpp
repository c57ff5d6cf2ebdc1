// run_time_error 0: THREATS 44, an exception whose type has a long name
#include "exercises/01_traversal/face_sides.h"

template <int n, class... T> struct Long : Long<n - 1, T..., T...> {};
template <class... T> struct Long<0, T...> {};
int face_sides(const HalfEdgeTable& he, int i) {
    if (he.size() > i) throw Long<11, int, long>();
    return 0;
}
