// Walks round the face on the left instead of round the vertex.
// Hint: You walk round a face where the vertex was asked for.
#include "exercises/05_structures/winged_faces.h"

#include <algorithm>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::vector<int> faces;
    int start = mesh.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return faces;
    int steps = 0;
    int face = mesh.edges[static_cast<std::size_t>(start)].left;
    int e = start;
    do {
        const WingedEdge& edge = mesh.edges[static_cast<std::size_t>(e)];
        if (edge.left != -1 &&
            std::find(faces.begin(), faces.end(), edge.left) == faces.end())
            faces.push_back(edge.left);
        if (edge.right != -1 &&
            std::find(faces.begin(), faces.end(), edge.right) == faces.end())
            faces.push_back(edge.right);
        if (++steps > static_cast<int>(mesh.edges.size())) break;
        e = edge.left == face ? edge.to_left : edge.from_right;
    } while (e != start);
    return faces;
}
