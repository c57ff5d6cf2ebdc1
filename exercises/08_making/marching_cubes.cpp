#include "exercises/08_making/marching_cubes.h"

IndexedMesh marching_cubes([[maybe_unused]] const DensityGrid& grid,
                           [[maybe_unused]] double level) {
    // TODO(student): look up each cell's case, and share the vertices of edges.
    return IndexedMesh();
}
