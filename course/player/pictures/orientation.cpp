#include "course/player/pictures/orientation.h"

#include <algorithm>
#include <optional>
#include <set>

#include "course/player/pictures/elements.h"

namespace course {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

class Walk {
public:
    explicit Walk(const IndexedMesh& mesh)
        : mesh_(mesh), turned_(at(mesh.faces.size())) {}

    void visit(int f, bool turned) {
        turned_[at(f)] = turned;
        for (const std::array<int, 2> edge : turned_sides_of(f))
            if (const std::optional<int> g = across(edge, f))
                if (passed_.insert(std::minmax(edge[0], edge[1])).second)
                    pass(edge, f, *g);
    }

    std::vector<OrientationStep> steps;

private:
    void pass(std::array<int, 2> edge, int f, int g) {
        const bool first = !turned_[at(g)].has_value();
        const bool alike = runs_along(g, edge);
        steps.push_back({edge, f, g, alike, first});
        if (first) visit(g, alike);
    }

    /// The sides of f in its sense as it is by now.
    std::vector<std::array<int, 2>> turned_sides_of(int f) const {
        std::vector<int> corners(mesh_.faces[f].begin(), mesh_.faces[f].end());
        if (turned_[at(f)].value_or(false))
            std::reverse(corners.begin(), corners.end());
        return sides_of(corners);
    }

    /// As it is by now.
    bool runs_along(int f, std::array<int, 2> edge) const {
        const auto sides = turned_sides_of(f);
        return std::find(sides.begin(), sides.end(), edge) != sides.end();
    }

    std::optional<int> across(std::array<int, 2> edge, int f) const {
        for (int g = 0; g < mesh_.faces.size(); ++g)
            if (g != f &&
                (runs_along(g, edge) || runs_along(g, {edge[1], edge[0]})))
                return g;
        return std::nullopt;
    }

    const IndexedMesh& mesh_;
    std::vector<std::optional<bool>> turned_;
    std::set<std::pair<int, int>> passed_;
};

}  // namespace

std::vector<OrientationStep> pass_orientation(const IndexedMesh& mesh) {
    Walk walk(mesh);
    if (!mesh.faces.empty()) walk.visit(0, false);
    return walk.steps;
}

bool is_orientable(const IndexedMesh& mesh) {
    const std::vector<OrientationStep> steps = pass_orientation(mesh);
    return std::none_of(
        steps.begin(), steps.end(),
        [](const OrientationStep& s) { return s.alike && !s.first; });
}

}  // namespace course
