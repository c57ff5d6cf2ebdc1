#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    std::vector<int> voisines;
    const int start = i;
    do {
        int f = he[he[i].opp].fi;
        // chaque face une seule fois
        if (f != he[start].fi &&
            std::find(voisines.begin(), voisines.end(), f) == voisines.end())
            voisines.push_back(f);
        i = he[i].next;
    } while (i != start);
    return voisines;
}
