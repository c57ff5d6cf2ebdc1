// The walks, written once for all libraries, so that nothing differs but how
// the half-edges are stored.
//
// A Mesh has:  int vertices(), faces(), half_edges()
//              int leaving(v), along(f)        a half-edge; -1 for none
//              int next(h), opposite(h), tip(h), face(h)   face -1: border
//              int corner(h)                   tip or start, as is cheaper
//              Vec3 position(v)
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "course/bench/peers.h"
#include "course/mesh/vec3.h"

namespace bench {

inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

template <class Mesh>
double sum_of_stars(const Mesh& mesh) {
    std::int64_t sum = 0;
    for (int v = 0; v < mesh.vertices(); ++v) {
        const int start = mesh.leaving(v);
        if (start == -1) continue;
        std::int64_t tips = 0;
        int h = start;
        do {
            tips += mesh.tip(h);
            h = mesh.next(mesh.opposite(h));
        } while (h != start);
        sum += tips * (v % 7 + 1);
    }
    return static_cast<double>(sum);
}

template <class Mesh>
double sum_of_faces(const Mesh& mesh) {
    std::int64_t sum = 0;
    for (int f = 0; f < mesh.faces(); ++f) {
        const int start = mesh.along(f);
        int sides = 0;
        int h = start;
        do {
            ++sides;
            h = mesh.next(h);
        } while (h != start);
        sum += long{sides} * (f % 3 + 1);
    }
    return static_cast<double>(sum);
}

template <class Mesh>
double sum_of_adjacent_faces(const Mesh& mesh) {
    std::int64_t sum = 0;
    for (int f = 0; f < mesh.faces(); ++f) {
        const int start = mesh.along(f);
        int h = start;
        do {
            sum += mesh.face(mesh.opposite(h)) + 1;
            h = mesh.next(h);
        } while (h != start);
    }
    return static_cast<double>(sum);
}

template <class Mesh>
double sum_of_border_loops(const Mesh& mesh) {
    std::vector<char> seen(at(mesh.half_edges()));
    std::int64_t sum = 0;
    for (int start = 0; start < mesh.half_edges(); ++start) {
        if (mesh.face(start) != -1 || seen[at(start)]) continue;
        std::int64_t length = 0;
        int h = start;
        do {
            seen[at(h)] = 1;
            ++length;
            h = mesh.next(h);
        } while (h != start);
        sum += length * length + 1;
    }
    return static_cast<double>(sum);
}

template <class Mesh>
Vec3 face_normal(const Mesh& mesh, int f) {
    const int start = mesh.along(f);
    const Vec3 apex = mesh.position(mesh.corner(start));
    int h = mesh.next(start);
    Vec3 before = mesh.position(mesh.corner(h)) - apex;
    Vec3 normal;
    for (h = mesh.next(h); h != start; h = mesh.next(h)) {
        const Vec3 here = mesh.position(mesh.corner(h)) - apex;
        normal = normal + cross(before, here);
        before = here;
    }
    return normal;
}

template <class Mesh>
double sum_of_vertex_normals(const Mesh& mesh) {
    std::vector<Vec3> of_face(at(mesh.faces()));
    for (int f = 0; f < mesh.faces(); ++f)
        of_face[at(f)] = face_normal(mesh, f);
    std::vector<Vec3> of_vertex(at(mesh.vertices()));
    for (int v = 0; v < mesh.vertices(); ++v) {
        const int start = mesh.leaving(v);
        if (start == -1) continue;
        Vec3 normal;
        int h = start;
        do {
            if (mesh.face(h) != -1) normal = normal + of_face[at(mesh.face(h))];
            h = mesh.next(mesh.opposite(h));
        } while (h != start);
        const double size = length(normal);
        if (size > 0) of_vertex[at(v)] = (1 / size) * normal;
    }
    double sum = 0;
    for (const Vec3& n : of_vertex) sum += n.x + 2 * n.y + 3 * n.z;
    return sum;
}

inline double sum_of_corners(const FaceList& faces) {
    const std::vector<int>& corners = faces.corners();
    return static_cast<double>(
        std::accumulate(corners.begin(), corners.end(), std::int64_t{0}));
}

template <class Mesh>
FaceList back_to_faces(const Mesh& mesh) {
    FaceList faces;
    faces.reserve(at(mesh.faces()), at(mesh.half_edges()));
    std::vector<int> corners;
    for (int f = 0; f < mesh.faces(); ++f) {
        corners.clear();
        const int start = mesh.along(f);
        int h = start;
        do {
            corners.push_back(mesh.corner(h));
            h = mesh.next(h);
        } while (h != start);
        faces.push_back(corners);
    }
    return faces;
}

template <class Mesh>
double sum_of(const Mesh& mesh, Walk walk) {
    switch (walk) {
        case Walk::stars:
            return sum_of_stars(mesh);
        case Walk::faces:
            return sum_of_faces(mesh);
        case Walk::adjacent_faces:
            return sum_of_adjacent_faces(mesh);
        case Walk::border_loops:
            return sum_of_border_loops(mesh);
        case Walk::vertex_normals:
            return sum_of_vertex_normals(mesh);
        case Walk::back_to_faces:
            return sum_of_corners(back_to_faces(mesh));
    }
    return 0;
}

}  // namespace bench
