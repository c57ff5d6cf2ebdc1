// Ends at the first level that has not come down to half.
// Hint: You end the pyramid at a level that has fewer faces than the one
// before, if not half as many.
#include "exercises/09_processing/lod_pyramid.h"

#include <set>

namespace {

int face_count(const HalfEdgeTable& he) {
    std::set<int> faces;
    for (const HalfEdge& row : he)
        if (row.fi != -1) faces.insert(row.fi);
    return int(faces.size());
}

double mean_length(const HalfEdgeTable& he, std::span<const Vec3> positions) {
    double sum = 0;
    for (int i = 0; i < he.size(); ++i) {
        Vec3 start = positions[std::size_t(he[i].vi)];
        Vec3 tip = positions[std::size_t(he[he[i].opp].vi)];
        sum += length(tip - start);
    }
    return sum / he.size();
}

}  // namespace

std::vector<LevelOfDetail> lod_pyramid(const HalfEdgeTable& he,
                                       std::span<const Vec3> positions,
                                       int levels) {
    if (levels < 1) throw std::invalid_argument("a pyramid has a level");
    std::vector<LevelOfDetail> pyramid = {{he, 1}};
    while (int(pyramid.size()) < levels) {
        const HalfEdgeTable& finer = pyramid.back().he;
        int faces = face_count(finer);
        HalfEdgeTable coarser = simplify(finer, positions, faces / 2);
        if (face_count(coarser) > faces / 2) break;
        double from =
            mean_length(coarser, positions) / mean_length(he, positions);
        pyramid.push_back({coarser, from});
    }
    return pyramid;
}
