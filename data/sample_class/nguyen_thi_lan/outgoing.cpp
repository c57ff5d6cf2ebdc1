#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors, int v) {
    std::vector<int> out;
    int i = anchors.vertex.at(v + 1);   // vertices count from 1?
    int start = i;
    do {
        out.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return out;
}
