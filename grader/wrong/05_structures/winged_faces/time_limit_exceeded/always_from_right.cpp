// Goes on by from_right, wherever v is.
// Hint: You do not come back to the first edge: at some edges you go on the
// wrong way.
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
        if (face != -1 &&
            std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
        e = edge.from_right;
    } while (e != start);
    return faces;
}
