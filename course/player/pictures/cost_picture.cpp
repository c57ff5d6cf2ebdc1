// What a query costs: the faces at a vertex, by a search of the list of faces
// and by a walk on half-edges. Reads are counted, by the table itself and by a
// list that counts.
#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/player/json.h"
#include "course/player/pictures/elements.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

/// The list of faces; counts how often a corner is read.
class CountedFaces {
public:
    explicit CountedFaces(const FaceList& faces) : faces_(faces) {}
    int size() const { return faces_.size(); }
    int sides(int f) const { return static_cast<int>(faces_[f].size()); }
    int corner(int f, int k) {
        ++reads_;
        return faces_[f][static_cast<std::size_t>(k)];
    }
    std::int64_t reads() const { return reads_; }

private:
    const FaceList& faces_;
    std::int64_t reads_ = 0;
};

/// Looks at every corner; on_face(f, found) is told of each face.
template <class OnFace>
void search(CountedFaces& faces, int v, OnFace on_face) {
    for (int f = 0; f < faces.size(); ++f) {
        bool found = false;
        for (int k = 0; k < faces.sides(f); ++k)
            if (faces.corner(f, k) == v) found = true;
        on_face(f, found);
    }
}

/// Walks once round the vertex that half-edge i leaves; on_face(i, f) is told
/// of each face.
template <class OnFace>
void walk(const HalfEdgeTable& he, int i, OnFace on_face) {
    const int start = i;
    do {
        const int here = i;
        const int f = he[i].fi;
        i = he[i].opp;
        i = he[i].next;
        on_face(here, f);
    } while (i != start);
}

/// A vertex in the middle of grid(n, n).
int middle_of_grid(int n) {
    return (n / 2) * (n + 1) + n / 2;
}

/// Both queries, step by step, on a mesh that can be seen.
Json queries(int n) {
    const IndexedMesh mesh = grid(n, n, Cells::triangles);
    const HalfEdgeTable he = build(mesh);
    const int v = middle_of_grid(n);
    std::vector<Json> searched, walked;
    CountedFaces faces(mesh.faces);
    search(faces, v, [&](int f, bool found) {
        searched.push_back(Json::object(
            {{"face", f}, {"found", found}, {"reads", faces.reads()}}));
    });
    he.begin_call(he.default_budget());
    walk(he, leaving(he, v), [&](int i, int f) {
        walked.push_back(
            Json::object({{"i", i}, {"face", f}, {"reads", he.reads()}}));
    });
    return Json::object({{"points", mesh.positions},
                         {"faces", mesh.faces},
                         {"table", he.rows()},
                         {"vertex", v},
                         {"search", searched},
                         {"walk", walked},
                         {"walk_reads", he.reads()}});
}

/// The numbers of reads alone.
Json counted(int n) {
    const IndexedMesh mesh = grid(n, n, Cells::triangles);
    const HalfEdgeTable he = build(mesh);
    const int v = middle_of_grid(n);
    const int start = leaving(he, v);
    CountedFaces faces(mesh.faces);
    search(faces, v, [](int, bool) {});
    he.begin_call(he.default_budget());
    walk(he, start, [](int, int) {});
    return Json::object({{"faces", mesh.faces.size()},
                         {"search", faces.reads()},
                         {"walk", he.reads()}});
}

}  // namespace

std::string cost_picture() {
    std::vector<Json> growing;
    for (const int n : {3, 10, 32, 100, 316, 707})
        growing.push_back(counted(n));
    return Json::object({{"query", queries(3)}, {"growing", growing}}).text();
}

}  // namespace course
