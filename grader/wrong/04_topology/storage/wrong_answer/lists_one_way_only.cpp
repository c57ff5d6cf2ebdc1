// Stores each meeting once, not at both.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 2 * n.edges + 2 * corners};
}
