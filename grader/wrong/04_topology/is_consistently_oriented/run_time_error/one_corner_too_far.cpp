// Reads the corner after the last one.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <set>
#include <stdexcept>
#include <vector>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (FaceList::Face face : mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        for (std::size_t k = 0; k < corners.size(); ++k)
            if (!sides.insert({corners.at(k), corners.at(k + 1)}).second)
                return false;
    }
    return true;
}
