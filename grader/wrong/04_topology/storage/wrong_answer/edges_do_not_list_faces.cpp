// Takes the edges' faces for two, border or not.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 6 * n.edges + 3 * corners};
}
