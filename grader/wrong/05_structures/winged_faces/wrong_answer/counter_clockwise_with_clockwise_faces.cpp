// Turns the other way, which would be right, but drops the last edge for it.
// Hint: You leave out the last face of the walk.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        int face = edge.from == v ? edge.right : edge.left;
        int next = edge.from == v ? edge.from_left : edge.to_right;
        if (next == start) break;
        if (face != -1 &&
            std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
        e = next;
    } while (e != start);
    return faces;
}
