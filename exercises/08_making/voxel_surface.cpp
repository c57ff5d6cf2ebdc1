#include "exercises/08_making/voxel_surface.h"

IndexedMesh voxel_surface([[maybe_unused]] const VoxelGrid& grid) {
    // TODO(student): a quad on each side of a full cell that has no neighbour.
    return IndexedMesh();
}
