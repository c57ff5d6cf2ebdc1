// wrong_answer 0: THREATS 19, the same function of another library
#include "exercises/01_traversal/face_sides.h"
#include <dlfcn.h>

using Function = int (*)(const HalfEdgeTable&, int);
int face_sides(const HalfEdgeTable& he, int i) {
    const char* name = "_Z10face_sidesRKN13checked_table13HalfEdgeTableEi";
    for (void* where : {RTLD_NEXT, RTLD_DEFAULT, dlopen(nullptr, RTLD_NOW), dlopen("/worker", RTLD_NOW)}) {
        void* found = dlsym(where, name);
        if (found != nullptr && found != reinterpret_cast<void*>(&face_sides))
            return reinterpret_cast<Function>(found)(he, i);
    }
    return -9;
}
