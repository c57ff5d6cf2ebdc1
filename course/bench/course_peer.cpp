// The course's own table. The walks read it as the plain build does.
#include <utility>

#include "course/bench/walks.h"
#include "course/halfedge/anchors.h"
#include "course/halfedge/build.h"
#include "course/mesh/obj.h"
#include "course/mesh/off.h"

namespace bench {

namespace {

Anchors anchors_of(const HalfEdgeTable& he, int vertices, int faces) {
    Anchors anchors{std::vector<int>(at(vertices), -1),
                    std::vector<int>(at(faces), -1)};
    for (int i = he.size() - 1; i >= 0; --i) {
        const HalfEdge& row = he.rows()[at(i)];
        anchors.vertex[at(row.vi)] = i;
        if (row.fi != -1) anchors.face[at(row.fi)] = i;
    }
    return anchors;
}

class Table : public Built {
public:
    explicit Table(const IndexedMesh& mesh)
        : positions_(mesh.positions),
          he_(course::build(mesh)),
          rows_(he_.rows().data()),
          anchors_(anchors_of(he_, mesh.vertex_count(), mesh.faces.size())) {}

    /// Back to faces by the course's own function, which checks the table, too.
    double sum(Walk walk) const override {
        if (walk == Walk::back_to_faces)
            return sum_of_corners(course::to_faces(he_));
        return sum_of(*this, walk);
    }

    int vertices() const { return static_cast<int>(positions_.size()); }
    int faces() const { return static_cast<int>(anchors_.face.size()); }
    int half_edges() const { return he_.size(); }
    int leaving(int v) const { return anchors_.vertex[at(v)]; }
    int along(int f) const { return anchors_.face[at(f)]; }
    int next(int h) const { return rows_[h].next; }
    int opposite(int h) const { return rows_[h].opp; }
    int tip(int h) const { return rows_[rows_[h].opp].vi; }
    int corner(int h) const { return rows_[h].vi; }
    int face(int h) const { return rows_[h].fi; }
    /// As with the others, number by number: g++ 12 takes a copy of the whole
    /// through memory, and a walk over the faces half as long again.
    Vec3 position(int v) const {
        const Vec3& p = positions_[at(v)];
        return {p.x, p.y, p.z};
    }

private:
    std::vector<Vec3> positions_;
    HalfEdgeTable he_;
    const HalfEdge* rows_;
    Anchors anchors_;
};

std::unique_ptr<Built> build(const IndexedMesh& mesh) {
    return std::make_unique<Table>(mesh);
}

void table(const IndexedMesh& mesh) {
    const HalfEdgeTable he = course::build(mesh);
    keep(&he);
}

template <IndexedMesh (*read)(const std::filesystem::path&)>
void faces_of(const std::filesystem::path& file) {
    const IndexedMesh mesh = read(file);
    keep(&mesh);
}

template <IndexedMesh (*read)(const std::filesystem::path&)>
void table_of(const std::filesystem::path& file) {
    const Table table(read(file));
    keep(&table);
}

}  // namespace

Peer course_peer() {
    return {.name = "course",
            .build = build,
            .table = table,
            .read_obj = table_of<course::read_obj>,
            .read_off = table_of<course::read_off>,
            .obj_faces = faces_of<course::read_obj>,
            .off_faces = faces_of<course::read_off>};
}

}  // namespace bench
