// Counts faces with the -1 of the border among them.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/euler.h"

#include <set>

int euler(const HalfEdgeTable& he) {
    std::set<int> vertices, faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        faces.insert(he[i].fi);
    }
    return static_cast<int>(vertices.size()) - he.size() / 2 +
           static_cast<int>(faces.size());
}
