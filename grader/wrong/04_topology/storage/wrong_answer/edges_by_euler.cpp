// Works the edges out as V + F - 2.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    int e = n.vertices + n.faces - 2;
    return {corners, 8 * e, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 4 * n.edges + 4 * corners};
}
