// compile_error 0: THREATS 5, a function whose control flow takes the compiler for ever
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

#define C1(n) case n: if (x % (n + 2) == 0) goto l##n; x ^= n; l##n:
#define X(a) x += (x > a ? (x < 3 ? x * a : x / (a | 1)) : (x == a ? -x : x + a));
#define X2 X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(10)
#define X3 X2 X2 X2 X2 X2 X2 X2 X2 X2 X2
#define X4 X3 X3 X3 X3 X3 X3 X3 X3 X3 X3
#define X5 X4 X4 X4 X4 X4 X4 X4 X4 X4 X4
#pragma GCC optimize("O3")
int bomb(int x) { X5 return x; }
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
