#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    std::set<int> s;
    int f = he[i].fi;
    if (f == -1) return {};
    for (int j = 0; j < he.size(); ++j) {
        int g = he[j].fi;
        // j is on the other side of an edge of f
        if (g != f && g != -1 && he[he[j].opp].fi == f) s.insert(g);
    }
    return {s.begin(), s.end()};
}
