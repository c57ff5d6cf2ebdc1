#include "course/player/pictures/elements.h"

#include <algorithm>

namespace course {

std::vector<std::array<int, 2>> sides_of(FaceList::Face corners) {
    std::vector<std::array<int, 2>> sides;
    for (std::size_t k = 0; k < corners.size(); ++k)
        sides.push_back({corners[k], corners[(k + 1) % corners.size()]});
    return sides;
}

bool has_side(FaceList::Face corners, int a, int b) {
    const auto sides = sides_of(corners);
    return std::find(sides.begin(), sides.end(), std::array{a, b}) !=
           sides.end();
}

int leaving(const HalfEdgeTable& he, int v) {
    const std::vector<HalfEdge>& rows = he.rows();
    const auto row =
        std::find_if(rows.begin(), rows.end(),
                     [&](const HalfEdge& one) { return one.vi == v; });
    return static_cast<int>(row - rows.begin());
}

}  // namespace course
