// Has room for eight neighbours.
// Hint: You give up after a few steps; a vertex may have more edges.
#include "exercises/01_traversal/vertex_star.h"

std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {
    int start = i;
    int count = 0;
    int room[8];
    do {
        i = he[i].opp;
        if (count < 8) room[count++] = he[i].vi;
        i = he[i].next;
    } while (i != start);
    return std::vector<int>(room, room + count);
}
