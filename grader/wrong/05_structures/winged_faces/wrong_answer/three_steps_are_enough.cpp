// Takes at most three steps, as if three edges met at each vertex.
// Hint: You give up after a few steps; a vertex may have more edges.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int steps = 0;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        int face = edge.from == v ? edge.left : edge.right;
        if (face != -1 &&
            std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start && ++steps < 3);
    return faces;
}
