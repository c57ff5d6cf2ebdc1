// Makes a fan from the start of `border`, without a new vertex.
// Hint: You fill the hole without the new vertex in its middle.
#include "exercises/09_processing/fill_hole.h"

#include <algorithm>

HalfEdgeTable fill_hole(const HalfEdgeTable& he, int border, int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("no border");
    int new_face = 0;
    for (const HalfEdge& row : he) {
        new_face = std::max(new_face, row.fi + 1);
        if (new_vertex < 0 || row.vi == new_vertex)
            throw std::invalid_argument("not free");
    }
    HalfEdgeTable filled = he;
    int first = border;
    int i = he[border].next;
    while (he[he[i].next].next != border) {
        int there = filled.size(), back = there + 1;
        int after = he[i].next;
        filled.push_back({he[after].vi, new_face, first, back});
        filled.push_back({he[border].vi, -1, after, there});
        filled[first].fi = new_face;
        filled[i].fi = new_face++;
        filled[first].next = i;
        filled[i].next = there;
        first = back;
        i = after;
    }
    int last = he[i].next;
    filled[first].next = i;
    filled[last].next = first;
    for (int k : {first, i, last}) filled[k].fi = new_face;
    return filled;
}
