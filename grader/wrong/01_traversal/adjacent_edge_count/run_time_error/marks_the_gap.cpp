// Marks the faces across in an array, -1 too.
// Hint: You use the number of a face as an index, also where there is no face.
#include "exercises/01_traversal/adjacent_edge_count.h"

#include <vector>

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    std::vector<int> sides(he.size(), 0);
    int start = i;
    int count = 0;
    do {
        int fj = he[he[i].opp].fi;
        sides[fj]++;
        if (fj != -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
