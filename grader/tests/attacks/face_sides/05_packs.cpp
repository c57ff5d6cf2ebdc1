// compile_error 0: THREATS 5, lists of types that double
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

template <int n, class... T>
struct Pack : Pack<n - 1, T..., T..., int> {};
template <class... T>
struct Pack<0, T...> { static constexpr int value = sizeof...(T); };
int bomb = Pack<40>::value;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
