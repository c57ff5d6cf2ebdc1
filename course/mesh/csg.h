// Constructive solid geometry: solids as trees of operations, with primitives
// at the leaves. (Lecture "modelling")
#pragma once

#include "course/mesh/vec3.h"

/// What a node of a CSG tree is.
enum class CsgKind {
    ball,          ///< a primitive: centre `at`, radius size.x
    box,           ///< a primitive: lowest corner `at`, edges size.x, .y, .z
    cylinder,      ///< a primitive: upright on a disc in a plane z = at.z, with
                   ///< the centre `at`, radius size.x, height size.z
    union_of,      ///< of two nodes: what is in either of them, or in both
    intersection,  ///< of two nodes: what is in both of them
    difference,    ///< of two nodes: what is in the left one, not in the right
};

/// A node of a CSG tree: nodes stand in one list, and name each other by their
/// place in it.
struct CsgNode {
    CsgKind kind = CsgKind::ball;
    int left = -1, right = -1;  ///< for the three operations; -1 at primitives
    Vec3 at, size;              ///< for primitives

    friend bool operator==(const CsgNode&, const CsgNode&) = default;
};
