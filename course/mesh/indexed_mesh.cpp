// What submissions call of the face list.
#define COURSE_DEFINE_FACE_LIST
#include "course/mesh/indexed_mesh.h"
