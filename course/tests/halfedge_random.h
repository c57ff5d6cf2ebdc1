// Small random meshes for tests with brute-force oracles: no care is taken to
// make them sound, so that about every kind of defect turns up.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

using Random = std::mt19937_64;

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
