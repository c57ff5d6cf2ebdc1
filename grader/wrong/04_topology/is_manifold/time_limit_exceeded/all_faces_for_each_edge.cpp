// Counts the faces of each edge by a look at all faces.
// Hint: Your answers are right, but the larger the mesh is, the longer you
// search at every step.
#include "exercises/04_topology/is_manifold.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

bool has_two_faces_at_most(const IndexedMesh& mesh) {
    for (FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k];
            int b = face[(k + 1) % face.size()];
            int faces = 0;
            for (FaceList::Face other : mesh.faces)
                for (std::size_t j = 0; j < other.size(); ++j) {
                    int c = other[j];
                    int d = other[(j + 1) % other.size()];
                    if ((a == c && b == d) || (a == d && b == c)) ++faces;
                }
            if (faces > 2) return false;
        }
    return true;
}

/// What the faces at a vertex join there: the other ends of its edges.
using Joined = std::map<int, std::vector<int>>;

bool is_one_fan(const Joined& joined) {
    int start = joined.begin()->first;
    std::set<int> seen = {start};
    std::vector<int> todo = {start};
    while (!todo.empty()) {
        int end = todo.back();
        todo.pop_back();
        for (int other : joined.at(end))
            if (seen.insert(other).second) todo.push_back(other);
    }
    return seen.size() == joined.size();
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
        if (!joined.empty() && !is_one_fan(joined)) return false;
    return true;
}
