#include "grader/suites/02_border/oracle.h"

#include <algorithm>

namespace course::oracle {

std::vector<int> sample(const HalfEdgeTable& he) {
    constexpr int most = 100;
    const int n = std::min(he.size(), most);
    std::vector<int> chosen;
    for (int k = 0; k < n; ++k) chosen.push_back(k * he.size() / n);
    return chosen;
}

std::vector<int> border_rows(const HalfEdgeTable& he) {
    std::vector<int> found;
    for (int i = 0; i < he.size(); ++i)
        if (he.rows()[static_cast<std::size_t>(i)].fi == -1) found.push_back(i);
    return found;
}

}  // namespace course::oracle
