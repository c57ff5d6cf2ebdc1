// Small random meshes for tests with brute-force oracles: no care is taken to
// make them sound, so that about every kind of defect turns up.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

using Random = std::mt19937_64;

/// A mesh as failed tests show it.
inline std::string text_of(const IndexedMesh& mesh) {
    std::string text = std::to_string(mesh.vertex_count()) + " vertices";
    for (const auto face : mesh.faces) {
        text += " (";
        for (const int v : face) text += " " + std::to_string(v);
        text += " )";
    }
    for (const auto& [a, b] : mesh.loose_edges)
        text += " " + std::to_string(a) + "-" + std::to_string(b);
    return text;
}

/// A number from 0 to n-1, the same everywhere.
inline int below(int n, Random& random) {
    return static_cast<int>(random() % static_cast<unsigned>(n));
}

/// Corners of a face: mostly three or more, and mostly different.
template <class Vertex>
std::vector<int> random_corners(Vertex vertex, Random& random) {
    const int sides =
        below(12, random) == 0 ? below(3, random) : 3 + below(3, random);
    std::vector<int> corners;
    for (int k = 0; k < sides; ++k) {
        int v = vertex();
        if (std::find(corners.begin(), corners.end(), v) != corners.end() &&
            below(4, random) != 0)
            v = vertex();
        corners.push_back(v);
    }
    return corners;
}

/// A few polygons and loose edges over a few vertices.
inline IndexedMesh random_soup(Random& random) {
    IndexedMesh mesh;
    const int vertices = below(9, random);
    mesh.positions.resize(static_cast<std::size_t>(vertices));
    const int outside = below(8, random) == 0 ? 1 : 0;
    const auto vertex = [&] {
        if (vertices + outside == 0) return 0;
        return below(vertices + 2 * outside, random) - outside;
    };
    const int faces = below(6, random);
    for (int f = 0; f < faces; ++f) {
        std::vector<int> corners = random_corners(vertex, random);
        if (f > 0 && below(8, random) == 0) {
            const auto copied = mesh.faces[below(f, random)];
            corners.assign(copied.begin(), copied.end());
        }
        if (!corners.empty())
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        mesh.faces.push_back(corners);
    }
    const int loose = below(4, random);
    for (int e = 0; e < loose; ++e)
        mesh.loose_edges.push_back({vertex(), vertex()});
    return mesh;
}

/// The same face, wound the other way.
inline std::vector<int> turned(std::vector<int> corners) {
    std::reverse(corners.begin() + 1, corners.end());
    return corners;
}

/// Faces of a sound mesh turned over, repeated, mirrored, bent to other
/// vertices or joined to a wall.
inline IndexedMesh spoilt(const IndexedMesh& mesh, Random& random) {
    IndexedMesh bad{mesh.positions, {}, mesh.loose_edges};
    for (const auto face : mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        const int what = below(40, random);
        if (what == 0) bad.faces.push_back(corners);
        if (what == 1) corners = turned(corners);
        if (what == 2) bad.faces.push_back(turned(corners));
        if (what == 3) corners[0] = below(mesh.vertex_count(), random);
        if (what == 4)
            bad.faces.push_back(
                {corners[0], corners[1], below(mesh.vertex_count(), random)});
        if (what == 5) corners.push_back(corners.front());
        if (what == 6) corners.resize(2);
        if (what == 7) corners[1] = mesh.vertex_count() + below(2, random);
        bad.faces.push_back(corners);
    }
    return bad;
}

/// As random_soup, but each face and loose edge is kept only if the mesh stays
/// sound: no edge twice in one direction, no vertex twice in a face.
inline IndexedMesh random_sound_mesh(Random& random) {
    const int vertices = 3 + below(10, random);
    std::vector<std::vector<bool>> used(
        static_cast<std::size_t>(vertices),
        std::vector<bool>(static_cast<std::size_t>(vertices)));
    const auto side = [&](int a, int b) {
        return used[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    };
    IndexedMesh mesh;
    mesh.positions.resize(static_cast<std::size_t>(vertices));
    std::vector<int> all(mesh.positions.size());
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
    const int tries = below(60, random);
    for (int t = 0; t < tries; ++t) {
        for (std::size_t left = all.size(); left > 1; --left)
            std::swap(all[left - 1], all[random() % left]);
        const int sides = 3 + below(std::min(3, vertices - 2), random);
        const std::vector<int> face(all.begin(), all.begin() + sides);
        bool fits = true;
        for (std::size_t k = 0; k < face.size(); ++k)
            fits = fits && !side(face[k], face[(k + 1) % face.size()]);
        if (!fits) continue;
        for (std::size_t k = 0; k < face.size(); ++k)
            used[static_cast<std::size_t>(face[k])]
                [static_cast<std::size_t>(face[(k + 1) % face.size()])] = true;
        mesh.faces.push_back(face);
    }
    const int loose = below(5, random);
    for (int e = 0; e < loose; ++e) {
        const int a = below(vertices, random);
        const int b = below(vertices, random);
        if (a == b || side(a, b) || side(b, a)) continue;
        used[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = true;
        mesh.loose_edges.push_back({a, b});
    }
    return mesh;
}

}  // namespace course
