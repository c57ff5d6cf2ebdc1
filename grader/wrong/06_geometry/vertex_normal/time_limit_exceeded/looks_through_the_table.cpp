// Looks for the faces of the vertex in the whole table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/06_geometry/vertex_normal.h"

namespace {

double weight_of(Vec3 v, Vec3 p, Vec3 q, Weight weight) {
    double area = length(area_vector(v, p, q)) / 2;
    if (weight == Weight::uniform) return 1;
    if (weight == Weight::area) return area;
    return std::atan2(2 * area, dot(p - v, q - v));
}

}  // namespace

Vec3 vertex_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                   int i, Weight weight) {
    auto place = [&](int v) { return positions[static_cast<std::size_t>(v)]; };
    Vec3 sum;
    double weights = 0;
    for (int h = 0; h < he.size(); ++h) {
        if (he[h].vi != he[i].vi || he[h].fi == -1) continue;
        int j = he[h].next;
        int k = he[j].next;
        Vec3 v = place(he[h].vi), p = place(he[j].vi), q = place(he[k].vi);
        auto n = face_normal(v, p, q);
        if (!n) continue;
        double w = weight_of(v, p, q, weight);
        sum = sum + w * *n;
        weights += w;
    }
    if (length(sum) <= 1e-12 * weights) return {};
    return (1 / length(sum)) * sum;
}
