// Lists all other corners of the faces, those across a quad too.
// Hint: You list vertices that share a face with this one, but no edge.
#include "exercises/01_traversal/vertex_star.h"

#include <algorithm>

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int v = he[i].vi;
    int start = i;
    std::vector<int> star;
    do {
        int j = he[i].next;
        while (he[j].vi != v) {
            if (std::find(star.begin(), star.end(), he[j].vi) == star.end())
                star.push_back(he[j].vi);
            j = he[j].next;
        }
        i = he[he[i].opp].next;
    } while (i != start);
    return star;
}
