// Takes the mesh for closed when V - E + F is 2.
// Hint: You know closed meshes of one kind only; they may have handles, or
// more than one component.
#include "exercises/04_topology/is_closed.h"

#include <set>

bool is_closed(const HalfEdgeTable& he) {
    std::set<int> vertices, faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    return static_cast<int>(vertices.size()) - he.size() / 2 +
               static_cast<int>(faces.size()) ==
           2;
}
