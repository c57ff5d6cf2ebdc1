// Counts bytes, four for each integer.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {4 * corners, 32 * n.edges, 4 * (8 * n.edges + n.vertices + n.faces), 4 * (8 * n.edges + n.vertices + n.faces), 16 * (n.edges + corners)};
}
