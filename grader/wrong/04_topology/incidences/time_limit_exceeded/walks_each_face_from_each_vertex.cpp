// Looks for every vertex through all rows.
// Hint: Your answers are right, but you read the same rows of the table again
// and again.
#include "exercises/04_topology/incidences.h"

#include <set>

Incidences incidences(const HalfEdgeTable& he) {
    std::set<int> vertices;
    for (int i = 0; i < he.size(); ++i) vertices.insert(he[i].vi);
    int n = 0;
    for (int v : vertices)
        for (int i = 0; i < he.size(); ++i)
            if (he[i].vi == v && he[i].fi != -1) ++n;
    return {n, n, he.size()};
}
