// Reports a shared next once for each other half-edge that has it, too.
// Hint: You report the same finding several times.
#include "exercises/00_table/validate.h"

namespace {

bool is_row(const HalfEdgeTable& he, int i) {
    return 0 <= i && i < he.size();
}

void check_ranges(const HalfEdgeTable& he, int i, std::vector<Finding>& found) {
    if (he[i].vi < 0) found.push_back({Fault::vertex_out_of_range, i});
    if (he[i].fi < -1) found.push_back({Fault::face_out_of_range, i});
    if (!is_row(he, he[i].next)) found.push_back({Fault::next_out_of_range, i});
    if (!is_row(he, he[i].opp)) found.push_back({Fault::opp_out_of_range, i});
}

void check_opp(const HalfEdgeTable& he, int i, std::vector<Finding>& found) {
    int j = he[i].opp;
    if (!is_row(he, j)) return;
    if (j == i) found.push_back({Fault::opp_is_itself, i});
    if (he[j].opp != i) found.push_back({Fault::opp_not_mutual, i});
    if (he[j].vi == he[i].vi) found.push_back({Fault::opp_same_start, i});
}

void check_next(const HalfEdgeTable& he, int i, std::vector<Finding>& found) {
    int j = he[i].opp;
    int k = he[i].next;
    if (!is_row(he, k)) return;
    if (is_row(he, j) && he[k].vi != he[j].vi)
        found.push_back({Fault::next_not_at_tip, i});
    if (he[k].fi != he[i].fi) found.push_back({Fault::next_changes_face, i});
}

void check_shared(const HalfEdgeTable& he, int i, std::vector<Finding>& found) {
    int k = he[i].next;
    if (!is_row(he, k)) return;
    for (int m = 0; m < he.size(); ++m) {
        if (m == i || he[m].next != k) continue;
        found.push_back({Fault::next_shared, i});
    }
}

}  // namespace

std::vector<Finding> validate(const HalfEdgeTable& he) {
    std::vector<Finding> found;
    for (int i = 0; i < he.size(); ++i) {
        check_ranges(he, i, found);
        check_opp(he, i, found);
        check_next(he, i, found);
        check_shared(he, i, found);
    }
    return found;
}
