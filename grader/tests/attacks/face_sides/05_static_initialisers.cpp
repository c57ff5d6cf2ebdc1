// compile_error 0: THREATS 5, a million variables with constructors
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

struct V { V(); ~V(); };
#define P(a, b) P2(a, b)
#define P2(a, b) a##b
#define D V P(v, __COUNTER__);
#define D2 D D D D D D D D D D
#define D3 D2 D2 D2 D2 D2 D2 D2 D2 D2 D2
#define D4 D3 D3 D3 D3 D3 D3 D3 D3 D3 D3
#define D5 D4 D4 D4 D4 D4 D4 D4 D4 D4 D4
D5 D5 D5 D5 D5
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
