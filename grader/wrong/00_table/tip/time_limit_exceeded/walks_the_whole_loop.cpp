// Collects all vertices of the loop to give the second: a border may be long.
#include <vector>

#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    std::vector<int> vertices;
    int j = i;
    do {
        vertices.push_back(he[j].vi);
        j = he[j].next;
    } while (j != i);
    return vertices[1];
}
