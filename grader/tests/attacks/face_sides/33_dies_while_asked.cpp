// run_time_error 0: THREATS 33, ends as soon as it is asked, by a closed channel and a sleep
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

int face_sides(const HalfEdgeTable& he, int i) {
    close(3);
    sleep(1000);
    return he[i].fi;
}
