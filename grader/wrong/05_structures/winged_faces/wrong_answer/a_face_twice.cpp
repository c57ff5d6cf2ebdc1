// Lists a face as often as it touches the vertex.
// Hint: You list a face several times that the walk meets several times.
#include "exercises/05_structures/winged_faces.h"

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        int face = edge.from == v ? edge.left : edge.right;
        if (face != -1) faces.push_back(face);
        e = edge.from == v ? edge.from_right : edge.to_left;
    } while (e != start);
    return faces;
}
