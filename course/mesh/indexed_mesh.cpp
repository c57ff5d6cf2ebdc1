// What submissions call of the indexed mesh.
#define COURSE_DEFINE_INDEXED_MESH
#include "course/mesh/indexed_mesh.h"
