// wrong_answer or run_time_error 0: THREATS 44, prints control bytes and then fails, so that they are shown
#include "exercises/01_traversal/face_sides.h"
#include <cstdio>

int face_sides(const HalfEdgeTable& he, int i) {
    std::fputs("\x1b[2J\x1b]8;;http://x\x07 \xff\xfe </pre><script>alert(1)</script> ]]> \xe2\x80\xae =1+1\n", stdout);
    return he[i].fi + 77;
}
