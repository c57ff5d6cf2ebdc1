// Picture "normals": the three weights of a vertex normal, at the corner of a
// box whose sides are cut into triangles in two ways.
#pragma once

#include <array>
#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "course/player/pictures/shapes.h"

namespace course {

/// A triangle at the vertex, and what it counts by each weight.
struct WeighedTriangle {
    int face = -1;
    Vec3 normal;  ///< unit length
    double area = 0;
    double angle = 0;  ///< at the vertex, in radians
};

/// The corner of the box, vertex 0.
struct WeighedCorner {
    IndexedMesh mesh;
    std::vector<WeighedTriangle> triangles;  ///< in the order of the faces
    std::array<Vec3, 3> normals;  ///< uniform, area, angle: by the reference
};

/// Precondition: has_solutions().
WeighedCorner weighed_corner(Cut cut);

}  // namespace course
