#include "grader/suites/09_processing/face_lists.h"

#include <algorithm>

namespace course::hidden {

std::vector<std::vector<int>> faces_from_smallest(const FaceList& faces) {
    std::vector<std::vector<int>> all;
    for (const FaceList::Face face : faces) {
        std::vector<int> corners(face.begin(), face.end());
        std::rotate(corners.begin(),
                    std::min_element(corners.begin(), corners.end()),
                    corners.end());
        all.push_back(std::move(corners));
    }
    return all;
}

std::vector<Fixture> zoo_without_table() {
    return {zoo::moebius3q(), zoo::moebius5(),        zoo::klein4x4(),
            zoo::rp2_6(),     zoo::house_with_wall(), zoo::fan3()};
}

}  // namespace course::hidden
