// Given a border half-edge, it walks round the border, however long that is.
// Hint: Look again at what the contract says of a half-edge that has no face.
#include "exercises/06_geometry/polygon_normal.h"

Vec3 polygon_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                    int i) {
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

    if (length(sum) <= 1e-12 * size) return {};
    return (1 / length(sum)) * sum;
}
