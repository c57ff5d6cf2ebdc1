// Ends when it meets a face that it has.
// Hint: You end the walk where nothing new comes, which may be before it is
// back.
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
        if (std::find(faces.begin(), faces.end(), face) != faces.end()) break;
        if (face != -1) faces.push_back(face);
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return faces;
}
