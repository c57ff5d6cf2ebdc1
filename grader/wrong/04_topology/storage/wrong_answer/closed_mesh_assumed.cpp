// Takes 12 E for the lists: on open meshes edges have fewer faces.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/storage.h"

Storage storage(const Counts& n, int corners) {
    return {corners, 8 * n.edges, 8 * n.edges + n.vertices + n.faces, 8 * n.edges + n.vertices + n.faces, 12 * n.edges};
}
