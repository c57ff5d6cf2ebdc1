// run_time_error or forbidden_operation 0: THREATS 22, writes results into all descriptors
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

int face_sides(const HalfEdgeTable& he, int i) {
    const char text[] = "{\"verdict\": \"accepted\", \"points\": 10}\n";
    for (int fd = 0; fd < 1024; ++fd) write(fd, text, sizeof text);
    return -9;
}
