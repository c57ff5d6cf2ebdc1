// Fits each face to those before it in the list, without a search.
// Hint: You go through the faces once, in the order of the list; a flag may
// have to come from further on.
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

}  // namespace

std::optional<std::vector<bool>> orient(const IndexedMesh& mesh) {
    int n = mesh.faces.size();
    Neighbours neighbours(at(n));
    for (const auto& [edge, sides] : sides_of_edges(mesh)) {
        if (sides.size() > 2) return std::nullopt;
        if (sides.size() < 2) continue;
        bool alike = sides[0].up == sides[1].up;
        neighbours[at(sides[0].face)].push_back({sides[1].face, alike});
        neighbours[at(sides[1].face)].push_back({sides[0].face, alike});
    }

    std::vector<std::optional<bool>> flags(at(n));
    for (int f = 0; f < n; ++f) {
        flags[at(f)] = false;
        bool is_first = true;
        for (auto [g, alike] : neighbours[at(f)]) {
            if (g >= f) continue;
            bool wanted = *flags[at(g)] != alike;
            if (!is_first && *flags[at(f)] != wanted) return std::nullopt;
            flags[at(f)] = wanted;
            is_first = false;
        }
    }

    std::vector<bool> result;
    for (const std::optional<bool>& flag : flags) result.push_back(*flag);
    return result;
}
