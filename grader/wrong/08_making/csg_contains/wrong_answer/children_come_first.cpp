// Goes through the list once, as if children always stood before their parents.
// Hint: You are right about a primitive alone, and wrong about an operation on
// two: about what it means, or about which nodes of the list.
#include "exercises/08_making/csg_contains.h"

#include <cmath>
#include <vector>

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

bool csg_contains(std::span<const CsgNode> nodes, int root, Vec3 p) {
    std::vector<bool> in(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const CsgNode& node = nodes[k];
        bool left = node.left >= 0 && in[static_cast<std::size_t>(node.left)];
        bool right = node.right >= 0 && in[static_cast<std::size_t>(node.right)];
        switch (node.kind) {
            case CsgKind::ball: in[k] = in_ball(node, p); break;
            case CsgKind::box: in[k] = in_box(node, p); break;
            case CsgKind::cylinder: in[k] = in_cylinder(node, p); break;
            case CsgKind::union_of: in[k] = left || right; break;
            case CsgKind::intersection: in[k] = left && right; break;
            case CsgKind::difference: in[k] = left && !right; break;
        }
    }
    return in[static_cast<std::size_t>(root)];
}
