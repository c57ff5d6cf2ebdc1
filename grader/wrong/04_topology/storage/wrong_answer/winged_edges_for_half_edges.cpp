// Takes a winged edge for a half-edge: twice as many.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 16 * n.edges + n.vertices + n.faces, 4 * n.edges + 4 * corners};
}
