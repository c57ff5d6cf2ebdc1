// Takes two sides for each edge as the corners.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    (void)corners;
    return {2 * n.edges, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 12 * n.edges};
}
