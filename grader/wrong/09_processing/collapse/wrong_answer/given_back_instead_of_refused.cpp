// Gives the table back unchanged where it must refuse.
// Hint: You do not refuse where can_collapse says no.
#include "exercises/09_processing/collapse.h"

#include <string>

namespace {

void rename_start(HalfEdgeTable& he, int i, int vertex) {
    int start = i;
    do {
        he[i].vi = vertex;
        i = he[he[i].opp].next;
    } while (i != start);
}

int before(const HalfEdgeTable& he, int i) {
    int k = i;
    while (he[k].next != i) k = he[k].next;
    return k;
}

/// Takes half-edge i out of its face or border, and marks the rows that are of
/// no use any more.
void take_out(HalfEdgeTable& he, int i, std::vector<bool>& gone) {
    int after = he[i].next;
    int last = before(he, i);
    gone[std::size_t(i)] = true;
    if (he[i].fi == -1 || he[after].next != last) {
        he[last].next = after;
        return;
    }
    int x = he[after].opp;
    int y = he[last].opp;
    he[x].opp = y;
    he[y].opp = x;
    gone[std::size_t(after)] = true;
    gone[std::size_t(last)] = true;
}

HalfEdgeTable without(const HalfEdgeTable& he, const std::vector<bool>& gone) {
    std::vector<int> number;
    int n = 0;
    for (bool is_gone : gone) number.push_back(is_gone ? -1 : n++);

    HalfEdgeTable shorter;
    for (int i = 0; i < he.size(); ++i) {
        if (gone[std::size_t(i)]) continue;
        HalfEdge row = he[i];
        row.next = number[std::size_t(row.next)];
        row.opp = number[std::size_t(row.opp)];
        shorter.push_back(row);
    }
    return shorter;
}

}  // namespace

HalfEdgeTable collapse(const HalfEdgeTable& he, int i) {
    if (!can_collapse(he, i)) return he;
    int j = he[i].opp;
    HalfEdgeTable changed = he;
    std::vector<bool> gone(std::size_t(he.size()), false);
    rename_start(changed, i, he[j].vi);
    take_out(changed, i, gone);
    take_out(changed, j, gone);
    return without(changed, gone);
}
