// run_time_error 0: THREATS 44, an exception whose text breaks terminals and pages
#include "exercises/01_traversal/face_sides.h"
#include <stdexcept>
#include <string>

int face_sides(const HalfEdgeTable& he, int i) {
    (void)i;
    if (he.size() > 0) throw std::runtime_error(std::string("\xff\xfe\xc0\x80 \x1b[2J\x1b]0;title\x07 ]]> <script>alert(1)</script> &amp; \"' =cmd()\r\n\0 \u202e \v\f\b\x7f \xed\xa0\x80", 60));
    return 0;
}
