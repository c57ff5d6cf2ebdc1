// compile_error or accepted <=11: THREATS 5, a constant expression that takes memory
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

constexpr int eat() {
    std::array<std::array<int, 1000>, 1000> a{};
    for (auto& row : a)
        for (int& x : row) x = 1;
    return a[3][4];
}
template <int n>
struct More { static constexpr int value = (n + eat()) % 7 + More<n - 1>::value; };
template <>
struct More<0> { static constexpr int value = 0; };
int bomb = More<800>::value;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
