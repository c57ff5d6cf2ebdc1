#pragma once

#include <span>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/vec3.h"
#include "exercises/06_geometry/area_vector.h"
#include "exercises/06_geometry/face_normal.h"

/// What a face counts for in the mean of its normals.
enum class Weight {
    uniform,  ///< each face the same
    area,     ///< by its area
    angle,    ///< by its angle at the vertex, between its two sides there
};

/// Writes the name of the weight to a std::ostream. A template, so that
/// students' files need not include one.
template <class Stream>
Stream& operator<<(Stream& out, Weight weight) {
    constexpr const char* names[] = {"uniform", "area", "angle"};
    const int k = static_cast<int>(weight);
    out << (0 <= k && k < 3 ? names[k] : "no Weight");
    return out;
}

/// The normal of the vertex that half-edge i leaves: the weighted mean of the
/// normals of its triangles T, at unit length,
///     sum of w(T) n(T), divided by its length.
///
/// Its triangles are the faces that the walk round the vertex meets from i on
/// (opposite, then next), each as often as it is met: at a bow-tie, only the
/// fans that the table links. n(T) is the unit normal of T as face_normal has
/// it, w(T) is 1, or the area of T, or its angle at the vertex. Which half-edge
/// of the vertex is given does not matter; it may lie on the border.
/// Degenerate: a triangle for which face_normal has none counts for nothing.
/// The zero vector where the sum is not longer than 1e-12 times the sum of the
/// weights: at a vertex without faces, and where normals cancel out.
/// `positions[v]` is the place of vertex v. Neither the unit of length nor the
/// distance from the origin matters.
/// Precondition: the table is valid, 0 <= i < he.size(), there is a position
/// for every vi, every face at the vertex is a triangle.
/// Cost: a constant number of reads for each edge of the vertex.
/// Builds on: area_vector and face_normal, which you may call.
/// Example: at a corner of a cube that is cut into triangles, with the sides
/// +x, +y, +z, by angle: (1, 1, 1) / sqrt(3). (Lecture "modelling", normals at
/// vertices; lecture "mesh processing", normals per vertex, step 2)
Vec3 vertex_normal(const HalfEdgeTable& he, std::span<const Vec3> positions,
                   int i, Weight weight);
