// Makes lists to count what is in them, with room for a thousand at each corner.
// Hint: You make room for what was only to be counted.
#include "exercises/04_topology/storage.h"

#include <vector>

Storage storage(const Counts& n, int corners) {
    std::vector<int> lists(static_cast<std::size_t>(corners) * 1000);
    for (int k = 0; k < corners; ++k) lists[static_cast<std::size_t>(k)] = 1;
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 4 * n.edges + 4 * corners};
}
