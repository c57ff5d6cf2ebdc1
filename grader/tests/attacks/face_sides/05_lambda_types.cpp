// compile_error 0: THREATS 5, a name that doubles with each level
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

template <int n, class F>
auto grow(F f) {
    if constexpr (n == 0)
        return f;
    else
        return grow<n - 1>([f](auto x) { return f(f(x)); });
}
int bomb = grow<900>([](auto x) { return x; })(1);
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
