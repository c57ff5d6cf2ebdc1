// Takes a third of the half-edges for the number of the faces.
// Hint: You take some other number for the number of the faces.
#include "exercises/09_processing/lod_pyramid.h"


namespace {

int face_count(const HalfEdgeTable& he) {
    return he.size() / 3;
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
        if (face_count(coarser) == faces) break;
        double from =
            mean_length(coarser, positions) / mean_length(he, positions);
        pyramid.push_back({coarser, from});
    }
    return pyramid;
}
