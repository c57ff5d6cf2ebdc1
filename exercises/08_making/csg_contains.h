#pragma once

#include <span>

#include "course/mesh/csg.h"

/// Whether the point p is in the solid that node `root` of a CSG tree stands
/// for. nodes[root] may be any node of the list: a primitive, an operation on
/// primitives, or one on other operations; see course/mesh/csg.h for what each
/// kind means.
///
/// Primitives have their surface: a point at the distance of the radius from
/// the centre of a ball is in it. So a difference lacks the surface of what was
/// taken away: {ball of radius 2} minus {ball of radius 1} contains the points
/// at distance 2, and not those at distance 1.
/// Precondition: `root` is a place in the list; the nodes below it form a tree.
/// The nodes may stand in any order, children before or after their parents,
/// and the list may have others that are not below the root. Lengths are above
/// 0. A tree may be some thousand nodes deep.
/// Cost: at most one look at each node of the tree.
/// Example: nodes 0 = {ball, -1, -1, (0,0,0), (2,0,0)},
/// 1 = {box, -1, -1, (0,0,0), (2,2,2)}, 2 = {difference, 0, 1}: the ball
/// without one eighth contains (-1,0,0) and not (1,1,1).
/// (Lecture "modelling")
bool csg_contains(std::span<const CsgNode> nodes, int root, Vec3 p);
