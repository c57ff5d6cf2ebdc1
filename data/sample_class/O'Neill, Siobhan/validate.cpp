#include "exercises/00_table/validate.h"

std::vector<Finding> validate(const HalfEdgeTable& he) {
    std::vector<Finding> found;
    for (int i = 0; i < he.size(); ++i) {
        int j = he[i].opp;
        int k = he[i].next;
        bool j_ok = 0 <= j && j < he.size();
        bool k_ok = 0 <= k && k < he.size();
        if (he[i].vi < 0) found.push_back({Fault::vertex_out_of_range, i});
        if (he[i].fi < -1) found.push_back({Fault::face_out_of_range, i});
        if (!k_ok) found.push_back({Fault::next_out_of_range, i});
        if (!j_ok) found.push_back({Fault::opp_out_of_range, i});
        if (j_ok && j == i) found.push_back({Fault::opp_is_itself, i});
        if (j_ok && he[j].opp != i) found.push_back({Fault::opp_not_mutual, i});
        // out of time: opp_same_start and all the next_ ones are missing
    }
    return found;
}
