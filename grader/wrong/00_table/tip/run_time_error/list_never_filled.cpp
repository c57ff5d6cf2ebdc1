// Looks the tip up in a list of all tips that nobody has filled.
#include "exercises/00_table/tip.h"

#include <vector>

int tip(const HalfEdgeTable& he, int i) {
    std::vector<int> tips;
    if (he[i].vi == static_cast<int>(tips.size())) tips.push_back(he[i].vi);
    return tips.at(static_cast<std::size_t>(i));
}
