// The field is named `edges`.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {corners, 8 * n.edge, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 4 * n.edges + 4 * corners};
}
