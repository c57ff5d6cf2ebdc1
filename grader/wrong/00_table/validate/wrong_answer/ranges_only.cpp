// Asks only whether the numbers are in range, which a wrong table may well be.
// Hint: You ask only whether the numbers are in range.
#include "exercises/00_table/validate.h"

std::vector<Finding> validate(const HalfEdgeTable& he) {
    std::vector<Finding> found;
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].vi < 0) found.push_back({Fault::vertex_out_of_range, i});
        if (he[i].fi < -1) found.push_back({Fault::face_out_of_range, i});
        if (he[i].next < 0 || he[i].next >= he.size())
            found.push_back({Fault::next_out_of_range, i});
        if (he[i].opp < 0 || he[i].opp >= he.size())
            found.push_back({Fault::opp_out_of_range, i});
    }
    return found;
}
