// Along i, the half at b keeps the number.
// Hint: You give the new number to the wrong half of a triangle.
#include "exercises/09_processing/split_edge.h"

#include <algorithm>
#include <string>

namespace {

void refuse(const std::string& why) {
    throw std::invalid_argument(why);
}

/// The third corner of the triangle along i; -1 when there is no face.
int third_corner(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return -1;
    int last = he[he[i].next].next;
    if (he[last].next != i)
        refuse("face " + std::to_string(he[i].fi) + " is no triangle");
    return he[last].vi;
}

void require_free(const HalfEdgeTable& he, int vertex) {
    for (const HalfEdge& row : he)
        if (vertex < 0 || row.vi == vertex)
            refuse("vertex " + std::to_string(vertex) + " is not free");
}

int largest_face(const HalfEdgeTable& he) {
    int largest = -1;
    for (const HalfEdge& row : he) largest = std::max(largest, row.fi);
    return largest;
}

/// Cuts a face of four sides, of which `in` enters the new vertex, from there
/// to the corner across: into a part along `in` and one along what follows it.
void cut(HalfEdgeTable& he, int in, int part_of_in, int part_of_out) {
    int out = he[in].next;
    int across = he[out].next;
    int last = he[across].next;
    int there = he.size(), back = there + 1;

    he.push_back({he[out].vi, part_of_in, last, back});
    he.push_back({he[last].vi, part_of_out, out, there});
    he[in].next = there;
    he[across].next = back;
    for (int i : {in, last}) he[i].fi = part_of_in;
    for (int i : {out, across}) he[i].fi = part_of_out;
}

}  // namespace

HalfEdgeTable split_edge(const HalfEdgeTable& he, int i, int new_vertex) {
    if (i < 0 || i >= he.size())
        refuse("half-edge " + std::to_string(i) + " is no row of the table");
    int j = he[i].opp;
    int c = third_corner(he, i), d = third_corner(he, j);
    if (c == d && c != -1)
        refuse("vertex " + std::to_string(c) + " would be joined twice");
    require_free(he, new_vertex);

    // i ends at the new vertex, and j leaves it; the half at b is new.
    HalfEdgeTable split = he;
    int to_b = he.size(), from_b = to_b + 1;
    split[i].next = to_b;
    split[j].vi = new_vertex;
    split.push_back({new_vertex, he[i].fi, he[i].next, from_b});
    for (HalfEdge& row : split)
        if (row.next == j) row.next = from_b;
    split.push_back({he[j].vi, he[j].fi, j, to_b});

    int free_face = largest_face(he) + 1;
    if (c != -1) cut(split, i, free_face++, he[i].fi);
    if (d != -1) cut(split, from_b, free_face, he[j].fi);
    return split;
}
