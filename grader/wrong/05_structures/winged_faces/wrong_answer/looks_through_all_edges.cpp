// Looks through all edges, so that it lists faces the walk does not meet.
// Hint: You list faces that the walk from the edge of the vertex does not
// meet.
#include "exercises/05_structures/winged_faces.h"

#include <set>

std::vector<int> winged_faces(const WingedMesh& mesh, int v) {
    std::set<int> faces;
    for (const WingedEdge& edge : mesh.edges)
        if (edge.from == v || edge.to == v) faces.insert({edge.left, edge.right});
    faces.erase(-1);
    return {faces.begin(), faces.end()};
}
