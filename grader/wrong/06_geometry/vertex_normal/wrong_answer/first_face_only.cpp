// The normal of one face.
// Hint: Your normal is that of one face only.
#include "exercises/06_geometry/vertex_normal.h"

namespace {

/// Of the triangle v, p, q at its corner v.
double weight_of(Vec3 v, Vec3 p, Vec3 q, Weight weight) {
    double area = length(area_vector(v, p, q)) / 2;
    switch (weight) {
        case Weight::uniform:
            return 1;
        case Weight::area:
            return area;
        case Weight::angle:
            return std::atan2(2 * area, dot(p - v, q - v));
    }
    return 0;
}

}  // namespace

Vec3 vertex_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                   int i, Weight weight) {
    auto place = [&](int v) { return positions[static_cast<std::size_t>(v)]; };
    Vec3 sum;
    double weights = 0;
    int start = i;
    do {
        if (he[i].fi != -1) {
            int j = he[i].next;
            int k = he[j].next;
            Vec3 v = place(he[i].vi), p = place(he[j].vi), q = place(he[k].vi);
            if (auto n = face_normal(v, p, q)) {
                double w = weight_of(v, p, q, weight);
                sum = sum + w * *n;
                weights += w;
            }
        }
        i = he[i].opp;
        i = he[i].next;
    } while (false);

    if (length(sum) <= 1e-12 * weights) return {};
    return (1 / length(sum)) * sum;
}
