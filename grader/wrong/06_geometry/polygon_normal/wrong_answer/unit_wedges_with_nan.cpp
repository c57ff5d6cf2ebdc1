// Unit wedges, and a corner on a straight side makes NaN of the sum.
// Hint: You divide by a length that is 0 at a corner on a straight side.
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
        Vec3 leaving = place(he[k].vi) - place(he[j].vi);
        Vec3 n = cross(arriving, leaving);
        sum = sum + (1 / length(n)) * n;
        size += dot(arriving, arriving);
        i = j;
    } while (i != start);

    if (length(sum) <= 1e-12) return {};
    return (1 / length(sum)) * sum;
}
