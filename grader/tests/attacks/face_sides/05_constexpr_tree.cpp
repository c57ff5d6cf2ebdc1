// compile_error 0: THREATS 5, constant expressions below the limits of each, many of them
#include "exercises/01_traversal/face_sides.h"

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

template <int k>
consteval unsigned spin(unsigned n) {
    for (unsigned j = 0; j < 250000; ++j) n += j % 7 + k;
    return n;
}
template <int k>
struct Many { static constexpr unsigned value = spin<k>(21) + Many<k - 1>::value; };
template <>
struct Many<0> { static constexpr unsigned value = 0; };
unsigned bomb = Many<800>::value;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
