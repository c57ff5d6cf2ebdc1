// compile_error 0: THREATS 5, __VA_OPT__ recursion that scans a text again and again
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

#define E(...) E4(E4(E4(E4(__VA_ARGS__))))
#define E4(...) E3(E3(E3(E3(__VA_ARGS__))))
#define E3(...) E2(E2(E2(E2(__VA_ARGS__))))
#define E2(...) E1(E1(E1(E1(__VA_ARGS__))))
#define E1(...) E0(E0(E0(E0(__VA_ARGS__))))
#define E0(...) __VA_ARGS__
#define EMPTY()
#define DEFER(x) x EMPTY()
#define AGAIN() LOOP
#define LOOP(a, ...) a + a + DEFER(AGAIN)()(a + a, __VA_ARGS__)
int bomb = E(E(E(LOOP(1, 2))));
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
