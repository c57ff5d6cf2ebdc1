// Linear maps of space: scaling, turning, shearing, mirroring.
#pragma once

#include <array>

#include "course/mesh/vec3.h"

/// A matrix of three rows and three columns. rows[0] is the first row;
/// rows[0].y is the number in its second column.
struct Mat3 {
    std::array<Vec3, 3> rows;

    /// The vector that the map makes of v, a column.
    friend Vec3 operator*(const Mat3& m, Vec3 v) {
        return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)};
    }
    friend bool operator==(const Mat3&, const Mat3&) = default;
};
