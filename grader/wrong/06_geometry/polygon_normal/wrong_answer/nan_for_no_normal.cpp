// Divides by zero where the face has no normal.
// Hint: You decide otherwise than the contract which faces have no normal.
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
        sum = sum + cross(arriving, leaving);
        size += dot(arriving, arriving);
        i = j;
    } while (i != start);

    return (1 / length(sum)) * sum;
}
