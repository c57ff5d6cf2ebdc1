// Compares only the first two faces at an edge.
// Hint: You accept edges with more than two faces.
#include "exercises/04_topology/orient.h"

#include <algorithm>
#include <map>
#include <utility>

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

struct Side {
    int face;
    bool up;  // from the smaller vertex to the larger
};

/// A face across an edge, and whether both run along the edge alike.
struct Neighbour {
    int face;
    bool alike;
};

using SidesOfEdges = std::map<std::pair<int, int>, std::vector<Side>>;

SidesOfEdges sides_of_edges(const IndexedMesh& mesh) {
    SidesOfEdges sides;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            int a = face[k];
            int b = face[(k + 1) % face.size()];
            sides[{std::min(a, b), std::max(a, b)}].push_back({f, a < b});
        }
    }
    return sides;
}

using Neighbours = std::vector<std::vector<Neighbour>>;

/// Gives a flag to each face that can be reached from `start`; false when two
/// ways to a face do not agree.
bool spread(const Neighbours& neighbours, int start,
            std::vector<std::optional<bool>>& flags) {
    flags[at(start)] = false;
    std::vector<int> todo = {start};
    while (!todo.empty()) {
        int f = todo.back();
        todo.pop_back();
        for (auto [g, alike] : neighbours[at(f)]) {
            bool wanted = *flags[at(f)] != alike;
            if (!flags[at(g)]) {
                flags[at(g)] = wanted;
                todo.push_back(g);
            } else if (*flags[at(g)] != wanted) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

std::optional<std::vector<bool>> orient(const IndexedMesh& mesh) {
    int n = mesh.faces.size();
    Neighbours neighbours(at(n));
    for (const auto& [edge, sides] : sides_of_edges(mesh)) {
        if (sides.size() < 2) continue;
        bool alike = sides[0].up == sides[1].up;
        neighbours[at(sides[0].face)].push_back({sides[1].face, alike});
        neighbours[at(sides[1].face)].push_back({sides[0].face, alike});
    }

    std::vector<std::optional<bool>> flags(at(n));
    for (int f = 0; f < n; ++f)
        if (!flags[at(f)] && !spread(neighbours, f, flags)) return std::nullopt;

    std::vector<bool> result;
    for (const std::optional<bool>& flag : flags) result.push_back(*flag);
    return result;
}
