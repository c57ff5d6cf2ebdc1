#include "course/runner/smallest_failing.h"

#include <utility>

#include "course/halfedge/build.h"
#include "course/mesh/clean.h"

namespace course {

namespace {

IndexedMesh without_faces(const IndexedMesh& mesh, int first, int count) {
    IndexedMesh smaller{mesh.positions, {}, {}};
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (f < first || f >= first + count)
            smaller.faces.push_back(mesh.faces[f]);
    return drop_unused_vertices(smaller).mesh;
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
        for (int count = mesh_.faces.size() / 2; count > 1; count /= 2)
            leave_out(count);
        while (leave_out(1)) {
        }
        return mesh_;
    }

private:
    /// Each so many faces in their turn. Whether some can be left out.
    bool leave_out(int count) {
        const int before = mesh_.faces.size();
        for (int first = 0; first < mesh_.faces.size();)
            if (!take(without_faces(mesh_, first, count))) first += count;
        return mesh_.faces.size() < before;
    }

    bool take(IndexedMesh smaller) {
        if (left_ == 0 || smaller.faces.empty()) return false;
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
