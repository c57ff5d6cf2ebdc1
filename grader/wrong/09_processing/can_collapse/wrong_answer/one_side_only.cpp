// Looks for a triangle on the side of i alone.
// Hint: You look for a triangle on one side of the edge only.
#include "exercises/09_processing/can_collapse.h"

#include <algorithm>

namespace {

/// What lies round a vertex: the neighbours, and the faces, -1 on the border.
struct Round {
    std::vector<int> vertices;
    std::vector<int> faces;
};

bool has(const std::vector<int>& list, int x) {
    return std::find(list.begin(), list.end(), x) != list.end();
}

Round round_start(const HalfEdgeTable& he, int i) {
    Round round;
    int start = i;
    do {
        round.faces.push_back(he[i].fi);
        i = he[i].opp;
        round.vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return round;
}

/// The third corner of the triangle that i runs along; empty when there is no
/// face, or one of more sides.
std::vector<int> third_corner(const HalfEdgeTable& he, int i) {
    int last = he[he[i].next].next;
    if (he[i].fi == -1 || he[last].next != i) return {};
    return {he[last].vi};
}

bool linked_only_by(const std::vector<int>& corners, const Round& a,
                    const Round& b) {
    for (int v : a.vertices)
        if (has(b.vertices, v) && !has(corners, v)) return false;
    return true;
}

bool other_face_at_both(const Round& a, const Round& b, int left, int right) {
    for (int f : a.faces)
        if (f != -1 && f != left && f != right && has(b.faces, f)) return true;
    return false;
}

}  // namespace

bool can_collapse(const HalfEdgeTable& he, int i) {
    if (i < 0 || i >= he.size()) return false;
    int j = he[i].opp;
    Round a = round_start(he, i);
    Round b = round_start(he, j);
    std::vector<int> corners = third_corner(he, i);

    if (!linked_only_by(corners, a, b)) return false;
    if (other_face_at_both(a, b, he[i].fi, he[j].fi)) return false;

    bool a_on_border = has(a.faces, -1), b_on_border = has(b.faces, -1);
    bool border_edge = he[i].fi == -1 || he[j].fi == -1;
    if (a_on_border && b_on_border && !border_edge) return false;

    std::size_t edges =
        a.vertices.size() + b.vertices.size() - 2 - corners.size();
    return edges >= (a_on_border || b_on_border ? 2 : 3);
}
