#include "course/runner/smallest_failing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/clean.h"

namespace course {

namespace {

/// The mesh with the faces that choose(face) makes of its own.
template <class Choose>
IndexedMesh with_faces(const IndexedMesh& mesh, Choose choose) {
    IndexedMesh smaller{mesh.positions, {}, {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::vector<int> corners = choose(f);
        if (corners.size() >= 3) smaller.faces.push_back(corners);
    }
    return drop_unused_vertices(smaller).mesh;
}

std::vector<int> corners_of(const IndexedMesh& mesh, int f) {
    const FaceList::Face face = mesh.faces[f];
    return {face.begin(), face.end()};
}

IndexedMesh without_faces(const IndexedMesh& mesh, int first, int count) {
    return with_faces(mesh, [&](int f) {
        const bool stays = f < first || f >= first + count;
        return stays ? corners_of(mesh, f) : std::vector<int>{};
    });
}

IndexedMesh without_vertex(const IndexedMesh& mesh, int v) {
    return with_faces(mesh, [&](int f) {
        std::vector<int> corners = corners_of(mesh, f);
        std::erase(corners, v);
        return corners;
    });
}

class Shrinking {
public:
    Shrinking(const IndexedMesh& mesh,
              const std::function<bool(const IndexedMesh&)>& fails, int most)
        : mesh_(mesh),
          fails_(fails),
          left_(most),
          bow_ties_(!bow_tie_vertices(mesh).empty()) {}

    IndexedMesh result() {
        std::size_t corners = 0;
        do {
            corners = mesh_.faces.corners().size();
            leave_out_faces();
            leave_out_vertices();
        } while (mesh_.faces.corners().size() < corners);
        return mesh_;
    }

private:
    void leave_out_faces() {
        for (int count = mesh_.faces.size() / 2; count > 0; count /= 2)
            for (int first = 0; first < mesh_.faces.size();)
                if (!take(without_faces(mesh_, first, count))) first += count;
    }

    void leave_out_vertices() {
        for (int v = mesh_.vertex_count() - 1; v >= 0; --v)
            if (v < mesh_.vertex_count()) take(without_vertex(mesh_, v));
    }

    bool take(IndexedMesh smaller) {
        if (left_ == 0 || smaller.faces.empty() || !defects(smaller).empty())
            return false;
        if (!bow_ties_ && !bow_tie_vertices(smaller).empty()) return false;
        --left_;
        if (!fails_(smaller)) return false;
        mesh_ = std::move(smaller);
        return true;
    }

    IndexedMesh mesh_;
    const std::function<bool(const IndexedMesh&)>& fails_;
    int left_;
    bool bow_ties_;
};

}  // namespace

IndexedMesh smallest_failing(
    const IndexedMesh& mesh,
    const std::function<bool(const IndexedMesh&)>& fails, int most) {
    return Shrinking(mesh, fails, most).result();
}

}  // namespace course
