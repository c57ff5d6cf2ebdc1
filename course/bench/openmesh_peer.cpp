// OpenMesh's PolyMesh, with positions in double precision as ours.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <stdexcept>

#include "course/bench/walks.h"

namespace bench {

namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

int number(std::size_t i) {
    return static_cast<int>(i);
}

class PolyMesh : public Built {
public:
    explicit PolyMesh(const IndexedMesh& mesh) {
        const auto edges = (mesh.faces.corners().size() + 1) / 2 + 1;
        mesh_.reserve(mesh.positions.size(), edges + edges / 64,
                      at(mesh.faces.size()));
        for (const auto& [x, y, z] : mesh.positions)
            mesh_.add_vertex(Mesh::Point(x, y, z));
        std::vector<OpenMesh::VertexHandle> corners;
        for (const auto face : mesh.faces) {
            corners.clear();
            for (const int v : face) corners.emplace_back(v);
            if (!mesh_.add_face(corners).is_valid())
                throw std::runtime_error("OpenMesh refuses a face");
        }
    }

    double sum(Walk walk) const override { return sum_of(*this, walk); }

    int vertices() const { return number(mesh_.n_vertices()); }
    int faces() const { return number(mesh_.n_faces()); }
    int half_edges() const { return number(mesh_.n_halfedges()); }
    int leaving(int v) const {
        return mesh_.halfedge_handle(OpenMesh::VertexHandle(v)).idx();
    }
    int along(int f) const {
        return mesh_.halfedge_handle(OpenMesh::FaceHandle(f)).idx();
    }
    int next(int h) const {
        return mesh_.next_halfedge_handle(half_edge(h)).idx();
    }
    int opposite(int h) const {
        return mesh_.opposite_halfedge_handle(half_edge(h)).idx();
    }
    int tip(int h) const { return mesh_.to_vertex_handle(half_edge(h)).idx(); }
    int corner(int h) const { return tip(h); }
    int face(int h) const { return mesh_.face_handle(half_edge(h)).idx(); }
    Vec3 position(int v) const {
        const Mesh::Point& p = mesh_.point(OpenMesh::VertexHandle(v));
        return {p[0], p[1], p[2]};
    }

private:
    static OpenMesh::HalfedgeHandle half_edge(int h) {
        return OpenMesh::HalfedgeHandle(h);
    }

    Mesh mesh_;
};

std::unique_ptr<Built> build(const IndexedMesh& mesh) {
    return std::make_unique<PolyMesh>(mesh);
}

void read(const std::filesystem::path& file) {
    Mesh mesh;
    if (!OpenMesh::IO::read_mesh(mesh, file.string()))
        throw std::runtime_error("OpenMesh cannot read " + file.string());
    keep(&mesh);
}

}  // namespace

Peer openmesh_peer() {
    omerr().disable();  // what it refuses is thrown, and counted
    return {
        .name = "OpenMesh", .build = build, .read_obj = read, .read_off = read};
}

}  // namespace bench
