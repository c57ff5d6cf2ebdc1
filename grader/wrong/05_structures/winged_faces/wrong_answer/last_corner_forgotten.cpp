// Ends before the last corner.
// Hint: You leave out the last face of the walk.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int e = start;
    while (true) {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        e = edge.from == v ? edge.from_right : edge.to_left;
        if (e == start) return faces;
        int face = edge.from == v ? edge.left : edge.right;
        if (face != -1 &&
            std::find(faces.begin(), faces.end(), face) == faces.end())
            faces.push_back(face);
    }
}
