// Counts at each vertex: as many edges as faces, or one more. Two closed fans, or a
// closed and an open one, have such numbers, too.
// Hint: You do not see several fans at a vertex where one of them is closed.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

bool has_two_faces_at_most(const IndexedMesh& mesh) {
    std::map<std::pair<int, int>, int> faces;
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k];
            int b = face[(k + 1) % face.size()];
            if (++faces[{std::min(a, b), std::max(a, b)}] > 2) return false;
        }
    return true;
}

/// What the faces at a vertex join there: the other ends of its edges.
using Joined = std::map<int, std::vector<int>>;

bool counts_right(const Joined& joined) {
    std::size_t ends = 0;
    for (const auto& [end, others] : joined) ends += others.size();
    std::size_t faces = ends / 2;
    return joined.size() == faces || joined.size() == faces + 1;
}

}  // namespace

bool is_manifold(const IndexedMesh& mesh) {
    if (!has_two_faces_at_most(mesh)) return false;

    std::vector<Joined> at(mesh.positions.size());
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int before = face[(k + face.size() - 1) % face.size()];
            int after = face[(k + 1) % face.size()];
            Joined& joined = at[static_cast<std::size_t>(face[k])];
            joined[before].push_back(after);
            joined[after].push_back(before);
        }
    for (const Joined& joined : at)
        if (!joined.empty() && !counts_right(joined)) return false;
    return true;
}
