// What no library can beat: the bytes of the table or the file, read and
// written once in order.
#include <fstream>
#include <stdexcept>

#include "course/bench/walks.h"
#include "course/halfedge/half_edge_table.h"

namespace bench {

namespace {

std::vector<HalfEdge> rows_of(const IndexedMesh& mesh) {
    const std::vector<int>& corners = mesh.faces.corners();
    std::vector<HalfEdge> rows;
    rows.reserve(corners.size());
    for (const int v : corners) rows.push_back({v, v, v, v});
    return rows;
}

class Bytes : public Built {
public:
    explicit Bytes(const IndexedMesh& mesh)
        : positions_(mesh.positions), rows_(rows_of(mesh)) {}

    double sum(Walk walk) const override {
        std::int64_t sum = 0;
        for (const HalfEdge& row : rows_)
            sum += row.vi + row.fi + row.next + row.opp;
        if (walk == Walk::vertex_normals) {
            const std::vector<Vec3> normals = positions_;
            keep(normals.data());
        } else if (walk == Walk::back_to_faces) {
            const std::vector<int> corners(rows_.size(), 1);
            keep(corners.data());
        }
        return static_cast<double>(sum);
    }

private:
    std::vector<Vec3> positions_;
    std::vector<HalfEdge> rows_;
};

std::unique_ptr<Built> build(const IndexedMesh& mesh) {
    return std::make_unique<Bytes>(mesh);
}

void table(const IndexedMesh& mesh) {
    const std::vector<HalfEdge> rows = rows_of(mesh);
    keep(rows.data());
}

void read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<char> bytes(std::filesystem::file_size(file));
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!in) throw std::runtime_error("cannot read " + file.string());
    keep(bytes.data());
}

}  // namespace

Peer bytes_peer() {
    return {.name = "bytes",
            .build = build,
            .table = table,
            .read_obj = read,
            .read_off = read,
            .obj_faces = read,
            .off_faces = read};
}

}  // namespace bench
