// Winding neighbours compatibly, or the proof that it cannot be.
#include <algorithm>
#include <utility>

#include "course/mesh/clean.h"
#include "course/mesh/neighbours.h"

namespace course {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Goes through the mesh part by part, breadth first, so that proofs are short.
class Orienter {
public:
    explicit Orienter(const IndexedMesh& mesh)
        : mesh_(mesh),
          near_(mesh),
          from_(at(mesh.faces.size()), unseen),
          depth_(from_.size()),
          is_turned_(from_.size()) {
        for (int f = 0; f < mesh.faces.size(); ++f)
            if (from_[at(f)] == unseen) orient_part(f);
    }

    Cleaned result() && {
        Cleaned cleaned{mesh_, std::move(changes_), {}};
        cleaned.mesh.faces = {};
        for (int f = 0; f < mesh_.faces.size(); ++f) {
            const FaceList::Face face = mesh_.faces[f];
            std::vector<int> corners(face.begin(), face.end());
            if (is_turned_[at(f)])
                std::reverse(corners.begin() + 1, corners.end());
            cleaned.mesh.faces.push_back(corners);
            cleaned.face_of.push_back(f);
        }
        return cleaned;
    }

private:
    static constexpr int unseen = -2;
    static constexpr int root = -1;

    void orient_part(int start) {
        std::vector<int> part = {start};
        from_[at(start)] = root;
        int twisted = -1;
        for (std::size_t k = 0; k < part.size(); ++k) {
            const int f = part[k];
            const int first = near_.first(f);
            const int sides = static_cast<int>(mesh_.faces[f].size());
            for (int side = first; side < first + sides; ++side)
                if (!cross(side, part) && twisted == -1) twisted = side;
        }
        if (twisted != -1) changes_.push_back(proof(twisted));
        turn_the_fewer(part);
    }

    /// Adds the face across to the part, if it is new; false when it is not,
    /// and wound against what this side asks for.
    bool cross(int side, std::vector<int>& part) {
        if (near_.across(side) == -1) return true;
        const int f = near_.face(side);
        const int g = near_.face(near_.across(side));
        const bool turned = is_turned_[at(f)] != near_.is_alike(side);
        if (from_[at(g)] != unseen) return is_turned_[at(g)] == turned;
        from_[at(g)] = side;
        depth_[at(g)] = depth_[at(f)] + 1;
        is_turned_[at(g)] = turned;
        part.push_back(g);
        return true;
    }

    void turn_the_fewer(const std::vector<int>& part) {
        const auto is_turned = [&](int f) { return is_turned_[at(f)]; };
        const auto turned = std::count_if(part.begin(), part.end(), is_turned);
        if (2 * turned > std::ssize(part))
            for (const int f : part) is_turned_[at(f)] = !is_turned_[at(f)];
        Change change{.kind = ChangeKind::faces_turned};
        std::copy_if(part.begin(), part.end(), std::back_inserter(change.faces),
                     is_turned);
        std::sort(change.faces.begin(), change.faces.end());
        if (!change.faces.empty()) changes_.push_back(std::move(change));
    }

    /// From the two faces of a side up to where their ways from the first face
    /// of the part fork, and down again.
    Change proof(int side) const {
        std::vector<int> down;  // sides, from the one of the fork on
        std::vector<int> up;
        int f = near_.face(side);
        int g = near_.face(near_.across(side));
        while (f != g) {
            const bool is_f = depth_[at(f)] >= depth_[at(g)];
            int& deeper = is_f ? f : g;
            const int step = from_[at(deeper)];
            (is_f ? down : up).push_back(is_f ? step : near_.across(step));
            deeper = near_.face(step);
        }
        std::reverse(down.begin(), down.end());
        down.push_back(side);
        down.insert(down.end(), up.begin(), up.end());
        Change change{.kind = ChangeKind::twist_found};
        for (const int s : down) {
            change.faces.push_back(near_.face(s));
            change.vertices.insert(change.vertices.end(),
                                   {near_.start(s), near_.tip(s)});
        }
        return change;
    }

    const IndexedMesh& mesh_;
    Neighbours near_;
    std::vector<int> from_;   // the side across which a face was reached
    std::vector<int> depth_;  // steps from the first face of its part
    std::vector<bool> is_turned_;
    std::vector<Change> changes_;
};

}  // namespace

Cleaned orient_faces(const IndexedMesh& mesh) {
    return Orienter(mesh).result();
}

}  // namespace course
