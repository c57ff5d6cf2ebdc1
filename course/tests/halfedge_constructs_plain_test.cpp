// Everyday constructs in the plain build.
#undef COURSE_TABLE
#define COURSE_TABLE 0
#include "course/tests/halfedge_constructs.h"

TEST_CASE("every construct gives its outcome in the plain build") {
    for (const Construct& construct : constructs) {
        INFO(construct.name);
        CHECK(outcome(construct) == construct.outcome);
    }
}
