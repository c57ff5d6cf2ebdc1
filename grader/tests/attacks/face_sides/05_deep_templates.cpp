// compile_error 0: THREATS 5, a type that is its own argument
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

template <class T>
struct Grow { typename Grow<Grow<T>>::type type; };
Grow<int> bomb;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
