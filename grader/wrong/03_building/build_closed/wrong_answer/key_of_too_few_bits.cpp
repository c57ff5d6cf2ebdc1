// Both ends in one 32-bit number: large vertex numbers run into each other.
// Hint: With large vertex numbers you take two different edges for the same.
#include "exercises/03_building/build_closed.h"

#include <cstdint>
#include <unordered_map>

namespace {

std::uint32_t key(int from, int to) {
    return static_cast<std::uint32_t>(from) << 16 ^
           static_cast<std::uint32_t>(to);
}

}  // namespace

HalfEdgeTable build_closed(const IndexedMesh& mesh) {
    HalfEdgeTable he;
    std::unordered_map<std::uint32_t, int> from_to;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        int first = he.size();
        for (std::size_t k = 0; k < face.size(); ++k) {
            bool last = k + 1 == face.size();
            int i = he.size();
            he.push_back({face[k], f, last ? first : i + 1, -1});
            from_to[key(face[k], last ? face[0] : face[k + 1])] = i;
        }
    }
    for (int i = 0; i < he.size(); ++i)
        he[i].opp = from_to[key(he[he[i].next].vi, he[i].vi)];
    return he;
}
