// Turns faces over as long as some do not agree: on a Moebius band for ever.
// Hint: You go on turning faces over where no choice will do, and never come
// to an end.
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

    std::vector<std::optional<bool>> flags(at(n), false);
    for (bool changed = true; changed;) {
        changed = false;
        for (int f = 0; f < n; ++f)
            for (auto [g, alike] : neighbours[at(f)])
                if (g > f && (*flags[at(f)] != *flags[at(g)]) != alike) {
                    flags[at(g)] = !*flags[at(g)];
                    changed = true;
                }
    }

    std::vector<bool> result;
    for (const std::optional<bool>& flag : flags) result.push_back(*flag);
    return result;
}
