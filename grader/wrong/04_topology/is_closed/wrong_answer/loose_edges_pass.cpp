// Looks for edges with exactly one face: a loose edge has none.
// Hint: You do not see that the mesh is open at an edge without any face.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1 && he[he[i].opp].fi != -1) return false;
    return true;
}
