#include "exercises/02_border/boundary_loops.h"

#include <set>

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he)
{
    // tutte le half-edge senza faccia, da consumare
    std::set<int> resto;
    for (int i = 0; i < he.size(); i++)
        if (he[i].fi < 0) resto.insert(i);

    std::vector<std::vector<int>> giri;
    while (!resto.empty()) {
        giri.emplace_back();
        int i = *resto.begin();
        while (resto.erase(i) > 0) {
            giri.back().push_back(i);
            i = he[i].next;
        }
    }
    return giri;
}
