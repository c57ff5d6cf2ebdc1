// Takes a side without a face for the end of the walk.
// Hint: You stop where there is no face; the walk goes on behind the gap.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        int face = edge.from == v ? edge.left : edge.right;
        if (face == -1) break;
        if (std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return faces;
}
