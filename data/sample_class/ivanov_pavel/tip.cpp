#include "exercises/00_table/tip.h"

#include <vector>

int tip(const HalfEdgeTable& he, int i) {
    std::vector<double> v(1, 0.0);
    while (v.size() > 0) v.insert(v.end(), 1 << 20, v.size());
    return he[he[i].opp].vi;
}
