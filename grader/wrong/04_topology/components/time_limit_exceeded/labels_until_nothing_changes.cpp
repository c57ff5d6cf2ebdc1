// Passes labels along all edges, over and over, until none changes: right, but a
// long strip takes as many rounds as it is long.
// Hint: Your answers are right, but you read the same rows of the table again
// and again.
#include "exercises/04_topology/components.h"

#include <algorithm>
#include <map>
#include <set>

int components(const HalfEdgeTable& he) {
    std::map<int, int> label;
    for (int i = 0; i < he.size(); ++i) label[he[i].vi] = he[i].vi;
    bool changed = true;
    while (changed) {
        changed = false;
        for (int i = 0; i < he.size(); ++i) {
            int& a = label[he[i].vi];
            int& b = label[he[he[i].opp].vi];
            if (a != b) changed = true;
            a = b = std::min(a, b);
        }
    }
    std::set<int> labels;
    for (const auto& [v, name] : label) labels.insert(name);
    return static_cast<int>(labels.size());
}
