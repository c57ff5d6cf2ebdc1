// compile_error 0: THREATS 5, two templates for each
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

template <int n, int m>
struct Bomb {
    static constexpr long value = Bomb<n - 1, 2 * m>::value + Bomb<n - 1, 2 * m + 1>::value;
};
template <int m>
struct Bomb<0, m> {
    static constexpr long value = m;
};
long bomb = Bomb<28, 0>::value;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
