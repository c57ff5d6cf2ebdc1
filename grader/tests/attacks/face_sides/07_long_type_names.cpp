// compile_error 0: THREATS 7, one error of megabytes
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

template <class... T> struct L {};
template <int n> struct G { using type = L<typename G<n - 1>::type, typename G<n - 1>::type>; };
template <> struct G<0> { using type = L<>; };
int bomb = typename G<17>::type();
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
