// Asks the children as if they were primitives.
// Hint: You know operations on primitives, but not those that stand above
// other operations.
#include "exercises/08_making/csg_contains.h"

#include <cmath>

namespace {

bool in_ball(const CsgNode& ball, Vec3 p) {
    return length(p - ball.at) <= ball.size.x;
}

bool is_between(double low, double length, double x) {
    return low <= x && x <= low + length;
}

bool in_box(const CsgNode& box, Vec3 p) {
    return is_between(box.at.x, box.size.x, p.x) &&
           is_between(box.at.y, box.size.y, p.y) &&
           is_between(box.at.z, box.size.z, p.z);
}

bool in_cylinder(const CsgNode& cylinder, Vec3 p) {
    double from_axis = std::hypot(p.x - cylinder.at.x, p.y - cylinder.at.y);
    return from_axis <= cylinder.size.x &&
           is_between(cylinder.at.z, cylinder.size.z, p.z);
}

}  // namespace

namespace {

bool in_primitive(const CsgNode& node, Vec3 p) {
    if (node.kind == CsgKind::ball) return in_ball(node, p);
    if (node.kind == CsgKind::box) return in_box(node, p);
    return in_cylinder(node, p);
}

}  // namespace

bool csg_contains(std::span<const CsgNode> nodes, int root, Vec3 p) {
    auto at = [&](int k) { return nodes[static_cast<std::size_t>(k)]; };
    CsgNode node = at(root);
    if (node.left == -1) return in_primitive(node, p);
    bool left = in_primitive(at(node.left), p);
    bool right = in_primitive(at(node.right), p);
    if (node.kind == CsgKind::union_of) return left || right;
    if (node.kind == CsgKind::intersection) return left && right;
    return left && !right;
}
