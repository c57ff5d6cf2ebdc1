#include "exercises/08_making/octree_leaves.h"

std::vector<OctreeLeaf> octree_leaves([[maybe_unused]] const VoxelGrid& grid) {
    // TODO(student): divide a cube as long as its cells are not all alike.
    return {};
}
