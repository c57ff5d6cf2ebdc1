// Does not join the first triangle and the last one.
// Hint: Your first new triangle and your last one do not meet.
#include "exercises/09_processing/fill_hole.h"

#include <algorithm>
#include <set>
#include <string>

namespace {

void refuse(const std::string& why) {
    throw std::invalid_argument(why);
}

void require_border(const HalfEdgeTable& he, int i) {
    if (i < 0 || i >= he.size() || he[i].fi != -1)
        refuse("half-edge " + std::to_string(i) + " is on no border");
}

void require_free(const HalfEdgeTable& he, int vertex) {
    for (const HalfEdge& row : he)
        if (vertex < 0 || row.vi == vertex)
            refuse("vertex " + std::to_string(vertex) + " is not free");
}

/// The half-edges of the border loop of i, if it comes to each vertex once.
std::vector<int> simple_loop(const HalfEdgeTable& he, int i) {
    std::vector<int> loop;
    std::set<int> met;
    int start = i;
    do {
        if (!met.insert(he[i].vi).second)
            refuse("the border comes to vertex " + std::to_string(he[i].vi) +
                   " twice");
        loop.push_back(i);
        i = he[i].next;
    } while (i != start);
    if (loop.size() < 3) refuse("the border is the two sides of one edge");
    return loop;
}

}  // namespace

HalfEdgeTable fill_hole(const HalfEdgeTable& he, int border, int new_vertex) {
    require_border(he, border);
    require_free(he, new_vertex);
    std::vector<int> loop = simple_loop(he, border);
    int new_face = 0;
    for (const HalfEdge& row : he) new_face = std::max(new_face, row.fi + 1);

    // Triangle k is loop[k], then in (to the new vertex), then out (back to the
    // start of loop[k]).
    HalfEdgeTable filled = he;
    int first = he.size();
    int last = first + 2 * int(loop.size()) - 1;
    for (int i : loop) {
        int in = filled.size(), out = in + 1;
        int in_before = i == loop.front() ? out : in - 2;
        int out_after = i == loop.back() ? in : out + 2;
        filled.push_back({he[he[i].opp].vi, new_face, out, out_after});
        filled.push_back({new_vertex, new_face, i, in_before});
        filled[i].next = in;
        filled[i].fi = new_face++;
    }
    return filled;
}
