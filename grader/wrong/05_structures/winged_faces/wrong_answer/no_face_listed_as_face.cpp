// Lists -1 at the border.
// Hint: You list -1 as a face where there is none.
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
        if (std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return faces;
}
