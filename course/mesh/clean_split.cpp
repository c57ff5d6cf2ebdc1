// A vertex for each fan of faces.
#include <algorithm>
#include <array>
#include <utility>

#include "course/mesh/clean.h"
#include "course/mesh/neighbours.h"

namespace course {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Faces of any other number at an edge, or wound alike, are no neighbours.
class Splitter {
public:
    explicit Splitter(const IndexedMesh& mesh)
        : mesh_(mesh),
          near_(mesh),
          positions_(mesh.positions),
          corners_(mesh.faces.corners().size(), -1) {
        // An upper bound: each corner gets a vertex of its own.
        require_countable(mesh.positions.size() + corners_.size(), 0, 0, 0);
        std::vector<bool> is_taken(mesh.positions.size());
        for (int c = 0; at(c) < corners_.size(); ++c) {
            if (corners_[at(c)] != -1) continue;
            const int v = near_.start(c);
            if (!is_sound_face(mesh, mesh.faces[near_.face(c)]))
                corners_[at(c)] = v;
            else if (is_taken[at(v)])
                copy_vertex(c);
            else
                give_fan(c, v);
            if (v >= 0 && v < mesh.vertex_count()) is_taken[at(v)] = true;
        }
    }

    Cleaned result() && {
        Cleaned cleaned{{std::move(positions_), {}, mesh_.loose_edges}, {}, {}};
        for (int f = 0; f < mesh_.faces.size(); ++f) {
            cleaned.mesh.faces.push_back(FaceList::Face(corners_).subspan(
                at(near_.first(f)), mesh_.faces[f].size()));
            cleaned.face_of.push_back(f);
        }
        report_edges(cleaned.changes);
        std::move(copies_.begin(), copies_.end(),
                  std::back_inserter(cleaned.changes));
        return cleaned;
    }

private:
    void copy_vertex(int corner) {
        const int v = near_.start(corner);
        const int copy = static_cast<int>(positions_.size());
        positions_.push_back(mesh_.positions[at(v)]);
        Change change{.kind = ChangeKind::vertex_split,
                      .faces = give_fan(corner, copy),
                      .vertices = {v, copy}};
        copies_.push_back(std::move(change));
    }

    /// The corner at the same vertex in the face across the side that leaves
    /// it, or across the one that comes in; -1 when that is no neighbour.
    int left_of(int corner) const {
        const int side = near_.across(corner);
        return side == -1 || near_.is_alike(corner) ? -1 : near_.next(side);
    }
    int right_of(int corner) const {
        const int in = near_.previous(corner);
        return near_.across(in) == -1 || near_.is_alike(in) ? -1
                                                            : near_.across(in);
    }

    /// Gives all corners of the fan that vertex; returns their faces.
    std::vector<int> give_fan(int corner, int vertex) {
        std::vector<int> faces;
        const auto give = [&](int c) {
            if (c == -1 || corners_[at(c)] != -1) return false;
            corners_[at(c)] = vertex;
            faces.push_back(near_.face(c));
            return true;
        };
        for (int c = corner; give(c);) c = left_of(c);
        for (int c = right_of(corner); give(c);) c = right_of(c);
        std::sort(faces.begin(), faces.end());
        return faces;
    }

    void report_edges(std::vector<Change>& changes) const {
        for_each_edge(
            near_.uses(), [&](const EdgeUse* use, const EdgeUse* end) {
                const bool is_sound =
                    end - use == 1 ||
                    (end - use == 2 && use[0].falling != use[1].falling);
                if (is_sound) return;
                Change change{.kind = ChangeKind::edge_split,
                              .vertices = {use->low, use->high}};
                std::vector<std::array<int, 2>> edges;
                for (; use != end; ++use) {
                    const int a = corners_[at(use->corner)];
                    const int b = corners_[at(near_.next(use->corner))];
                    change.faces.push_back(use->face);
                    edges.push_back({std::min(a, b), std::max(a, b)});
                }
                std::sort(edges.begin(), edges.end());
                change.count = static_cast<int>(
                    std::unique(edges.begin(), edges.end()) - edges.begin());
                changes.push_back(std::move(change));
            });
    }

    const IndexedMesh& mesh_;
    Neighbours near_;
    std::vector<Vec3> positions_;
    std::vector<int> corners_;  // the new vertex of each corner; -1: not yet
    std::vector<Change> copies_;
};

}  // namespace

Cleaned split_non_manifold(const IndexedMesh& mesh) {
    return Splitter(mesh).result();
}

}  // namespace course
