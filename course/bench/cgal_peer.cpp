// CGAL::Surface_mesh.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <stdexcept>

#include "course/bench/walks.h"

namespace bench {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int number(std::size_t i) {
    return static_cast<int>(i);
}

class Surface : public Built {
public:
    explicit Surface(const IndexedMesh& mesh) {
        using Index = Mesh::size_type;
        const auto edges = (mesh.faces.corners().size() + 1) / 2 + 1;
        mesh_.reserve(static_cast<Index>(mesh.positions.size()),
                      static_cast<Index>(edges + edges / 64),
                      static_cast<Index>(mesh.faces.size()));
        for (const auto& [x, y, z] : mesh.positions)
            mesh_.add_vertex(Point(x, y, z));
        std::vector<Mesh::Vertex_index> corners;
        for (const auto face : mesh.faces) {
            corners.clear();
            for (const int v : face)
                corners.emplace_back(static_cast<Index>(v));
            if (mesh_.add_face(corners) == Mesh::null_face())
                throw std::runtime_error("CGAL refuses a face");
        }
    }

    double sum(Walk walk) const override { return sum_of(*this, walk); }

    int vertices() const { return number(mesh_.num_vertices()); }
    int faces() const { return number(mesh_.num_faces()); }
    int half_edges() const { return number(mesh_.num_halfedges()); }
    int leaving(int v) const {
        const auto h = mesh_.halfedge(Mesh::Vertex_index(index(v)));
        return h == Mesh::null_halfedge() ? -1 : number(mesh_.opposite(h));
    }
    int along(int f) const {
        return number(mesh_.halfedge(Mesh::Face_index(index(f))));
    }
    int next(int h) const { return number(mesh_.next(half_edge(h))); }
    int opposite(int h) const { return number(mesh_.opposite(half_edge(h))); }
    int tip(int h) const { return number(mesh_.target(half_edge(h))); }
    int corner(int h) const { return tip(h); }
    int face(int h) const {
        return static_cast<int>(mesh_.face(half_edge(h)).idx());
    }
    Vec3 position(int v) const {
        const Point& p = mesh_.point(Mesh::Vertex_index(index(v)));
        return {p.x(), p.y(), p.z()};
    }

private:
    static Mesh::size_type index(int i) {
        return static_cast<Mesh::size_type>(i);
    }
    static Mesh::Halfedge_index half_edge(int h) {
        return Mesh::Halfedge_index(index(h));
    }

    Mesh mesh_;
};

std::unique_ptr<Built> build(const IndexedMesh& mesh) {
    return std::make_unique<Surface>(mesh);
}

void read_obj(const std::filesystem::path& file) {
    Mesh mesh;
    if (!CGAL::IO::read_OBJ(file.string(), mesh))
        throw std::runtime_error("CGAL cannot read " + file.string());
    keep(&mesh);
}

void read_off(const std::filesystem::path& file) {
    Mesh mesh;
    if (!CGAL::IO::read_OFF(file.string(), mesh))
        throw std::runtime_error("CGAL cannot read " + file.string());
    keep(&mesh);
}

template <class Read>
void read_faces(const std::filesystem::path& file, Read read) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!read(file.string(), points, faces))
        throw std::runtime_error("CGAL cannot read " + file.string());
    keep(&faces);
}

void obj_faces(const std::filesystem::path& file) {
    read_faces(file, [](const auto& name, auto& points, auto& faces) {
        return CGAL::IO::read_OBJ(name, points, faces);
    });
}

void off_faces(const std::filesystem::path& file) {
    read_faces(file, [](const auto& name, auto& points, auto& faces) {
        return CGAL::IO::read_OFF(name, points, faces);
    });
}

}  // namespace

Peer cgal_peer() {
    return {.name = "CGAL",
            .build = build,
            .read_obj = read_obj,
            .read_off = read_off,
            .obj_faces = obj_faces,
            .off_faces = off_faces};
}

}  // namespace bench
