// compile_error 0: THREATS 5, overload resolution of exponential cost
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

struct A { template <class T> operator T(); };
template <class T> auto f(T t, int n) -> decltype(f(A(), f(t, n)) + f(A(), f(t, n)));
template <int n> struct R { template <class T> static auto g(T t) -> decltype(R<n - 1>::g(t) + R<n - 1>::g(&t)); };
template <> struct R<0> { template <class T> static int g(T); };
int bomb = R<24>::g(1);
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
