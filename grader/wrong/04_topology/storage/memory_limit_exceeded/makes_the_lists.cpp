// Makes a list with an entry for each, a million times over.
#include "exercises/04_topology/storage.h"

#include <vector>

Storage storage(const Counts& n, int corners) {
    std::vector<std::vector<int>> faces;
    for (int k = 0; k < corners; ++k)
        faces.push_back(std::vector<int>(1000));
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 4 * n.edges + 4 * corners};
}
