// Marks the vertices of the border: two loops at one vertex are taken for one.
// Hint: You mark vertices; a border may pass a vertex twice.
#include "exercises/04_topology/counts.h"

#include <set>

Counts counts(const HalfEdgeTable& he) {
    std::set<int> vertices;
    std::set<int> faces;
    for (int i = 0; i < he.size(); ++i) {
        vertices.insert(he[i].vi);
        if (he[i].fi != -1) faces.insert(he[i].fi);
    }
    int loops = 0;
    std::set<int> seen;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || seen.count(he[start].vi) > 0) continue;
        ++loops;
        int i = start;
        do {
            seen.insert(he[i].vi);
            i = he[i].next;
        } while (i != start);
    }
    return {static_cast<int>(vertices.size()), he.size() / 2, static_cast<int>(faces.size()), loops};
}
