// Takes the two faces of the one edge that it is given.
// Hint: You look at one edge only; a vertex may have more.
#include "exercises/05_structures/winged_faces.h"

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int e = mesh.vertex[static_cast<std::size_t>(v)];
    if (e == -1) return faces;
    const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
    if (edge.left != -1) faces.push_back(edge.left);
    if (edge.right != -1 && edge.right != edge.left) faces.push_back(edge.right);
    return faces;
}
