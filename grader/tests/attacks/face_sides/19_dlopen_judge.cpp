// wrong_answer 0: THREATS 19, loads the judge and asks its oracle
#include "exercises/01_traversal/face_sides.h"
#include <dlfcn.h>

int face_sides(const HalfEdgeTable& he, int i) {
    for (const char* path : {"@ROOT@/.build/judges/grade/face_sides", "@ROOT@/.build/judges/reference/face_sides", "/judge", "./judge"}) {
        void* judge = dlopen(path, RTLD_NOW);
        if (judge != nullptr) return he[i].fi == -1 ? 0 : 3;
    }
    return -9;
}
