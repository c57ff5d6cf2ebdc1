// Does not ask whether i is a half-edge.
// Hint: You do not refuse all numbers as the contract says: something else
// comes out than the exception that it names.
#include "exercises/09_processing/flip_edge.h"

#include <string>

namespace {

bool along_triangle(const HalfEdgeTable& he, int i) {
    return he[i].fi != -1 && he[he[he[i].next].next].next == i;
}

/// Whether an edge joins the start of i and vertex v.
bool joined(const HalfEdgeTable& he, int i, int v) {
    int start = i;
    do {
        i = he[i].opp;
        if (he[i].vi == v) return true;
        i = he[i].next;
    } while (i != start);
    return false;
}

void refuse(int i, const std::string& why) {
    throw std::invalid_argument("half-edge " + std::to_string(i) + ": " + why);
}

}  // namespace

HalfEdgeTable flip_edge(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    if (!along_triangle(he, i) || !along_triangle(he, j))
        refuse(i, "the edge has not a triangle on each side");

    int b_to_c = he[i].next, c_to_a = he[b_to_c].next;
    int a_to_d = he[j].next, d_to_b = he[a_to_d].next;
    int c = he[c_to_a].vi, d = he[d_to_b].vi;
    if (c == d || joined(he, c_to_a, d))
        refuse(i, "an edge would join vertices " + std::to_string(c) + " and " +
                      std::to_string(d) + " twice");

    HalfEdgeTable flipped = he;
    flipped[i].vi = d;
    flipped[i].next = c_to_a;
    flipped[c_to_a].next = a_to_d;
    flipped[a_to_d].next = i;
    flipped[a_to_d].fi = he[i].fi;

    flipped[j].vi = c;
    flipped[j].next = d_to_b;
    flipped[d_to_b].next = b_to_c;
    flipped[b_to_c].next = j;
    flipped[b_to_c].fi = he[j].fi;
    return flipped;
}
