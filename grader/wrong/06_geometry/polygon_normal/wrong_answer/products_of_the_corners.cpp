// Right in exact numbers: the products of positions lose all digits far from
// the origin.
// Hint: You lose digits: numbers cancel out that grow with the distance from
// the origin.
#include "exercises/06_geometry/polygon_normal.h"

Vec3 polygon_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                    int i) {
    if (he[i].fi == -1) return {};

    auto place = [&](int v) { return positions[static_cast<std::size_t>(v)]; };
    Vec3 sum;
    double size = 0;
    int start = i;
    do {
        int j = he[i].next;
        int k = he[j].next;
        Vec3 arriving = place(he[j].vi) - place(he[i].vi);
        Vec3 p = place(he[i].vi), q = place(he[j].vi), r = place(he[k].vi);
        sum = sum + cross(p, q) + cross(q, r) + cross(r, p);
        size += dot(arriving, arriving);
        i = j;
    } while (i != start);

    if (length(sum) <= 1e-12 * size) return {};
    return (1 / length(sum)) * sum;
}
